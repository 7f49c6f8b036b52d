#include "coupling/triaxial/triaxial_walls.h"

#include "coupling/stones/box_walls.h"

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// So far walls go on beyond the box that the stones are poured into, on all sides: a block that is
// squashed to half its height and dilates grows by less [m].
double reach_of(const BoxParameters& box)
{
  return box.length + box.width;
}

// Across x and y of the moving walls, across z of the plate [m2].
Vector3 areas(const Vector3& size)
{
  return {size.y() * size.z(), size.x() * size.z(), size.x() * size.y()};
}

int direction(const TriaxialWalls& walls, dem::WallId wall)
{
  return wall == walls.x_moving ? 0 : wall == walls.y_moving ? 1 : 2;
}
} // namespace

TriaxialWalls build_triaxial_box(dem::Engine& engine, const BoxParameters& box,
                                 const dem::ContactProperties& contact)
{
  const double reach = reach_of(box);
  const Vector3 along_x(box.length + 2 * reach, 0, 0), along_y(0, box.width + 2 * reach, 0);
  const Vector3 up(0, 0, hopper_height);
  const auto add = [&](const char* name, const Vector3& corner, const Vector3& edge1,
                       const Vector3& edge2) {
    return engine.add_wall(dem::rectangle_wall(name, corner, edge1, edge2, contact));
  };
  TriaxialWalls walls;
  walls.floor = add("floor", {-reach, -reach, 0}, along_x, along_y);
  walls.x_fixed = add("x = 0", {0, -reach, 0}, along_y, up);
  walls.x_moving = add("x = length", {box.length, -reach, 0}, along_y, up);
  walls.y_fixed = add("y = 0", {-reach, 0, 0}, along_x, up);
  walls.y_moving = add("y = width", {-reach, box.width, 0}, along_x, up);
  return walls;
}

void add_plate(dem::Engine& engine, TriaxialWalls& walls, const BoxParameters& box, double height)
{
  const double reach = reach_of(box);
  walls.plate = engine.add_wall(
      dem::rectangle_wall("plate", {-reach, -reach, height}, {box.length + 2 * reach, 0, 0},
                          {0, box.width + 2 * reach, 0}, engine.wall(walls.floor).contact));
}

Vector3 block_size(const dem::Engine& engine, const TriaxialWalls& walls)
{
  return {engine.wall(walls.x_moving).corner.x() - engine.wall(walls.x_fixed).corner.x(),
          engine.wall(walls.y_moving).corner.y() - engine.wall(walls.y_fixed).corner.y(),
          engine.wall(walls.plate).corner.z() - engine.wall(walls.floor).corner.z()};
}

void keep_pressure(dem::Engine& engine, const TriaxialWalls& walls, dem::WallId wall,
                   double pressure, double largest_speed)
{
  const int d = direction(walls, wall);
  dem::ForceControl control;
  control.axis = -Vector3::Unit(d);
  control.force = pressure * areas(block_size(engine, walls))[d];
  control.largest_speed = largest_speed;
  engine.control_wall(wall, control);
}

void follow_areas(dem::Engine& engine, const TriaxialWalls& walls, double pressure)
{
  const Vector3 area = areas(block_size(engine, walls));
  for (const dem::WallId wall : {walls.x_moving, walls.y_moving, walls.plate})
    if (engine.keeps_force(wall))
      engine.set_controlled_force(wall, pressure * area[direction(walls, wall)]);
}

Vector3 wall_stresses(const dem::Engine& engine, const TriaxialWalls& walls)
{
  const auto force = [&](dem::WallId wall) { return engine.wall(wall).force; };
  const Vector3 pressing(force(walls.x_moving).x() - force(walls.x_fixed).x(),
                         force(walls.y_moving).y() - force(walls.y_fixed).y(),
                         force(walls.plate).z() - force(walls.floor).z());
  return 0.5 * pressing.cwiseQuotient(areas(block_size(engine, walls)));
}
} // namespace interlock::coupling
