// What a user says about an equilibrium path, and what the path is.
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <limits>
#include <vector>

namespace interlock::fem
{
// A state at rest under the load factor times the loads.
struct PathPoint {
  double load_factor;
  bool limit; // a limit point: the load factor is an extremum of the path, to some 1e-8 of itself
  std::vector<Eigen::Vector3d> displacement; // of the watched nodes, from the unloaded state [m]
};

// The arc of a step is the root mean square over all nodes of their displacement in it [m].
struct ArcLengthOptions {
  double first_load = 0.1; // load factor that the first step would reach on a straight path; its
                           // sign is the direction in which the path sets out
  double largest_arc = std::numeric_limits<double>::infinity(); // [m]
  int wanted_iterations = 4; // Newton iterations of a step; arcs grow and shrink towards it
  int max_iterations = 12;   // a step that needs more is halved
  int max_points = 1000;     // with `is_last` a limit, otherwise the length of the path
  std::vector<int> watched;  // nodes
  std::function<bool(const PathPoint&)> is_last; // ends the path; may stay empty
};
} // namespace interlock::fem
