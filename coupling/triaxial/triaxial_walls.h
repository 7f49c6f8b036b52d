// The walls of a triaxial test: floor, four sides, a plate. They are long and pass through each
// other at the edges of the block, so that sides which move leave no gap.
//
// Frame: x and y along the block, z up from the floor. The sides at x = 0 and y = 0 stay, so that
// the block does not drift; those opposite move.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "dem/engine/engine.h"

namespace interlock::coupling
{
struct TriaxialWalls {
  dem::WallId floor = -1;
  dem::WallId x_fixed = -1, x_moving = -1, y_fixed = -1, y_moving = -1;
  dem::WallId plate = -1; // on the stones; -1: none yet
};
template <class Archive> void exchange(Archive& archive, TriaxialWalls& walls)
{
  archive("floor", walls.floor);
  archive("x_fixed", walls.x_fixed);
  archive("x_moving", walls.x_moving);
  archive("y_fixed", walls.y_fixed);
  archive("y_moving", walls.y_moving);
  archive("plate", walls.plate);
}

// All but the plate, at rest.
TriaxialWalls build_triaxial_box(dem::Engine& engine, const BoxParameters& box,
                                 const dem::ContactProperties& stone_on_box);
// Adds the plate with its underside at `height` [m].
void add_plate(dem::Engine& engine, TriaxialWalls& walls, const BoxParameters& box, double height);

// Length, width and height between the walls [m]. There must be a plate.
dem::Vector3 block_size(const dem::Engine& engine, const TriaxialWalls& walls);

// From now on this wall keeps `pressure` [Pa] on its present area, at most `largest_speed` fast.
void keep_pressure(dem::Engine& engine, const TriaxialWalls& walls, dem::WallId wall,
                   double pressure, double largest_speed);
// Walls that keep a force keep this pressure on the area that they have now.
void follow_areas(dem::Engine& engine, const TriaxialWalls& walls, double pressure);

// Normal stress on the walls across x, y, z at the last step, each the mean of two opposite walls
// over their present area; positive when they press [Pa]. Complete on every rank while a wall
// moves.
dem::Vector3 wall_stresses(const dem::Engine& engine, const TriaxialWalls& walls);
} // namespace interlock::coupling
