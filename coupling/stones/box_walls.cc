#include "coupling/stones/box_walls.h"

namespace interlock::coupling
{
using dem::Vector3;

BoxWalls build_box(dem::Engine& engine, const BoxParameters& box,
                   const dem::ContactProperties& contact)
{
  const Vector3 x(box.length, 0, 0), y(0, box.width, 0), z(0, 0, hopper_height), origin(0, 0, 0);
  BoxWalls walls;
  walls.floor = engine.add_wall(dem::rectangle_wall("floor", origin, x, y, contact));
  walls.back = engine.add_wall(dem::rectangle_wall("back", x, y, z, contact));
  walls.right = engine.add_wall(dem::rectangle_wall("right", origin, x, z, contact));
  walls.left = engine.add_wall(dem::rectangle_wall("left", y, x, z, contact));
  walls.front = engine.add_wall(dem::rectangle_wall("front", origin, y, z, contact));
  return walls;
}

void open_slot(dem::Engine& engine, const BoxParameters& box, const dem::ContactProperties& contact,
               double height, BoxWalls& walls)
{
  std::vector<dem::WallId> closed = {walls.front};
  if (walls.above_slot >= 0) closed.push_back(walls.above_slot);
  engine.remove_walls(closed);
  const Vector3 y(0, box.width, 0);
  const double bottom = height - 0.5 * box.slot_height, top = height + 0.5 * box.slot_height;
  walls.front = engine.add_wall(
      dem::rectangle_wall("front below slot", Vector3::Zero(), y, Vector3(0, 0, bottom), contact));
  walls.above_slot = engine.add_wall(dem::rectangle_wall(
      "front above slot", Vector3(0, 0, top), y, Vector3(0, 0, hopper_height - top), contact));
}

dem::Wall box_plate(const std::string& name, const BoxParameters& box,
                    const dem::ContactProperties& contact, double height)
{
  return dem::rectangle_wall(name, {0, 0, height}, {box.length, 0, 0}, {0, box.width, 0}, contact);
}
} // namespace interlock::coupling
