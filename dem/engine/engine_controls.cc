// Walls of an engine that keep a force.
#include "dem/engine/engine.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace interlock::dem
{
void Engine::control_wall(WallId id, const ForceControl& control)
{
  check(control);
  wall_index(id); // must be there
  controls_.push_back({id, control});
}

void Engine::set_controlled_force(WallId id, double force)
{
  for (ControlledWall& controlled : controls_) {
    if (controlled.wall != id) continue;
    controlled.control.force = force;
    check(controlled.control);
    return;
  }
  throw std::invalid_argument("The wall " + std::to_string(id) + " keeps no force.");
}

bool Engine::keeps_force(WallId id) const
{
  return std::any_of(controls_.begin(), controls_.end(),
                     [&](const ControlledWall& c) { return c.wall == id; });
}

bool Engine::controlled_walls_press(double share) const
{
  return std::all_of(controls_.begin(), controls_.end(), [&](const ControlledWall& c) {
    return -wall(c.wall).force.dot(c.control.axis) >= share * c.control.force;
  });
}

void Engine::release_wall(WallId id)
{
  controls_.erase(std::remove_if(controls_.begin(), controls_.end(),
                                 [&](const ControlledWall& c) { return c.wall == id; }),
                  controls_.end());
}
} // namespace interlock::dem
