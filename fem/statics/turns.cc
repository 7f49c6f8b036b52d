#include "fem/statics/turns.h"

#include <algorithm>

namespace interlock::fem
{
double largest_turn(const StaticState& from, const StaticState& to)
{
  double largest = 0;
  for (std::size_t i = 0; i < from.orientation.size(); ++i)
    largest = std::max(largest, from.orientation[i].angularDistance(to.orientation[i]));
  return largest;
}

SharpestElement sharpest_element(const StaticState& state)
{
  SharpestElement sharpest;
  for (int e = 0; e < state.lattice.n_elements(); ++e) {
    const std::array<Eigen::Quaterniond, 2> ends = state.end_orientations(e);
    const double turn = ends[0].angularDistance(ends[1]);
    if (turn > sharpest.turn) sharpest = {e, turn};
  }
  return sharpest;
}
} // namespace interlock::fem
