#include "coupling/shear_box/shear_box_walls.h"

#include "coupling/stones/box_walls.h"

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// Four sides of the box between two heights [m].
std::vector<dem::WallId> add_sides(dem::Engine& engine, const std::string& half,
                                   const BoxParameters& box, double bottom, double top,
                                   const dem::ContactProperties& contact)
{
  const Vector3 x(box.length, 0, 0), y(0, box.width, 0), z(0, 0, top - bottom), b(0, 0, bottom);
  const auto add = [&](const char* side, const Vector3& corner, const Vector3& edge) {
    return engine.add_wall(dem::rectangle_wall(half + " " + side, corner, edge, z, contact));
  };
  return {add("x = 0", b, y), add("x = length", b + x, y), add("y = 0", b, x),
          add("y = width", b + y, x)};
}
} // namespace

ShearBoxWalls build_shear_box(dem::Engine& engine, const BoxParameters& box, double gap,
                              double distance, const dem::ContactProperties& contact,
                              const dem::ContactProperties& on_floor)
{
  const double plane = 0.5 * box.height, rim = plane - 0.5 * gap, edge = plane + 0.5 * gap;
  const Vector3 x(box.length, 0, 0), y(0, box.width, 0), reach(distance, 0, 0);
  ShearBoxWalls walls;
  walls.lower = {engine.add_wall(dem::rectangle_wall("floor", Vector3::Zero(), x, y, on_floor))};
  const auto sides = add_sides(engine, "lower", box, 0, rim, contact);
  walls.lower.insert(walls.lower.end(), sides.begin(), sides.end());
  walls.lower.push_back(
      engine.add_wall(dem::rectangle_wall("ledge", Vector3(-distance, 0, rim), reach, y, contact)));
  walls.upper = add_sides(engine, "upper", box, edge, hopper_height, contact);
  walls.cover =
      engine.add_wall(dem::rectangle_wall("cover", x + Vector3(0, 0, edge), reach, y, contact));
  return walls;
}

double displacement(const dem::Engine& engine, const ShearBoxWalls& walls)
{
  return engine.wall(walls.lower.front()).corner.x();
}

void set_speed(dem::Engine& engine, const ShearBoxWalls& walls, double speed)
{
  for (const dem::WallId id : walls.lower) engine.wall(id).velocity = {speed, 0, 0};
}

ShearForces shear_forces(const dem::Engine& engine, const ShearBoxWalls& walls)
{
  const Vector3 plate = engine.wall(walls.plate).force;
  ShearForces forces{plate.x(), 0, plate.z()};
  for (const dem::WallId id : walls.upper) {
    forces.shear += engine.wall(id).force.x();
    forces.friction += engine.wall(id).force.z();
  }
  return forces;
}
} // namespace interlock::coupling
