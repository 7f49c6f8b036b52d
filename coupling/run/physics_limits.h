// Beyond these a run is no simulation of anything any more, and ends.
#pragma once

#include "coupling/loop/world.h"

#include <Eigen/Geometry>

#include <limits>

namespace interlock::coupling
{
struct PhysicsLimits {
  // Where the centre of a stone may be, world [m]; a stone outside by more than its own radius has
  // gone through a wall.
  Eigen::AlignedBox3d region{dem::Vector3::Constant(-1e300), dem::Vector3::Constant(1e300)};
  double largest_overlap = std::numeric_limits<double>::infinity(); // of any contact [m]
  double break_strain = 0;       // of a rib in tension; 0: ribs do not break [-]
  bool live_stable_step = false; // the step must stay below Engine::stable_step
};

// Throws RunFailure with time, id, place and what to change when a number of the state is not
// finite or a limit is passed. Costs about as much as ten steps of a packed box.
void check_physics(const World& world, const PhysicsLimits& limits);

// Largest stretch of a rib that is pulled, axial force over axial stiffness and what is plastic
// [-], and its element; zero without a geogrid.
struct Stretch {
  double strain = 0;
  int element = -1;
};
Stretch largest_stretch(const World& world);
} // namespace interlock::coupling
