// The largest drop of the pull-out force in the history of a pull.
//
// The forces F of the records, each the mean since the record before, become F', their running
// median over `smooth` to either side, and over at least three records: what a single record says
// neither makes a drop nor hides one, and a step stays a step. A drop is the fall from a local
// maximum of F' to the lowest F' that follows within `within`. The largest one counts as a drop
// when it is at least `least` of the highest F' of the pull; anything below is scatter.
#pragma once

#include <optional>
#include <vector>

namespace interlock::apps
{
struct DropSearch {
  double from = 0;        // displacement from which on maxima count: the pull has begun [m]
  double within = 2e-3;   // displacement in which the force falls [m]
  double smooth = 0.1e-3; // half the length of the running median [m]
  double least = 0.1;     // fall over the highest force of the pull [-]
};

struct ForceDrop {
  struct Moment {
    double displacement = 0; // [m]
    double force = 0;        // F' [N]
  };
  Moment before, during, after; // the maximum; where half of the fall is made; the minimum
  double highest = 0;           // F' of the pull [N]
  bool counts = false;

  double fall() const { return before.force - after.force; } // [N]
};

// Median of the values at places within `half` of each place, and of its neighbours at least; at
// the ends of the first or last three.
std::vector<double> running_median(const std::vector<double>& place,
                                   const std::vector<double>& value, double half);

// `place` [m] ascends, as many values of `force` [N]. Among equal falls the first one. Nothing when
// the force never falls after `from`.
std::optional<ForceDrop> largest_drop(const std::vector<double>& place,
                                      const std::vector<double>& force, const DropSearch& search);
} // namespace interlock::apps
