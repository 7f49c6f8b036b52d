// The walls of a shear box. Frame: x along the way of the lower half, y across, z up from the
// floor; the halves meet at half the height of the box.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "dem/engine/engine.h"

#include <vector>

namespace interlock::coupling
{
struct ShearBoxWalls {
  // Floor first, four sides, and a ledge outside the side at x = 0 that comes in below the upper
  // half when the lower one moves towards +x: no stone falls out. They move together.
  std::vector<dem::WallId> lower;
  std::vector<dem::WallId> upper; // four sides, up to the hopper; they stay
  dem::WallId cover = -1;         // outside the upper half, above what the lower one uncovers
  dem::WallId plate = -1;         // on the stones; -1: none yet
};
template <class Archive> void exchange(Archive& archive, ShearBoxWalls& walls)
{
  archive("lower", walls.lower);
  archive("upper", walls.upper);
  archive("cover", walls.cover);
  archive("plate", walls.plate);
}

// Both halves without a plate, at rest, `gap` apart. The lower one may move by `distance` [m].
ShearBoxWalls build_shear_box(dem::Engine& engine, const BoxParameters& box, double gap,
                              double distance, const dem::ContactProperties& stone_on_box,
                              const dem::ContactProperties& stone_on_floor);

// Of the lower half since the begin [m].
double displacement(const dem::Engine& engine, const ShearBoxWalls& walls);

void set_speed(dem::Engine& engine, const ShearBoxWalls& walls, double speed); // [m/s]

// On the upper half and the plate, at the last step: what the stones below the plane transfer to
// those above it. Complete on every rank while a wall moves.
struct ShearForces {
  double shear = 0;    // along the way of the lower half [N]
  double friction = 0; // of the stones on the sides of the upper half, upwards [N]
  double plate = 0;    // with which the plate presses [N]
};
ShearForces shear_forces(const dem::Engine& engine, const ShearBoxWalls& walls);
} // namespace interlock::coupling
