// The box of a pull-out test. Frame: x along the pull, the front wall at x = 0; y across; z up from
// the floor.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "dem/engine/engine.h"

namespace interlock::coupling
{
struct BoxWalls {
  dem::WallId floor = -1, back = -1, right = -1, left = -1;
  dem::WallId front = -1;      // below the slot, once that is open
  dem::WallId above_slot = -1; // -1: there is no slot yet
};
template <class Archive> void exchange(Archive& archive, BoxWalls& walls)
{
  archive("floor", walls.floor);
  archive("back", walls.back);
  archive("right", walls.right);
  archive("left", walls.left);
  archive("front", walls.front);
  archive("above_slot", walls.above_slot);
}

// The walls go on this far up: they are the hopper too. Higher than any filling is poured from [m].
constexpr double hopper_height = 10;

// Adds floor, back, sides and a front wall without a slot.
BoxWalls build_box(dem::Engine& engine, const BoxParameters& box,
                   const dem::ContactProperties& stone_on_box);

// The front wall becomes a part below and a part above a slot, whose middle is at `height` [m]. A
// slot that is there already is opened anew.
void open_slot(dem::Engine& engine, const BoxParameters& box,
               const dem::ContactProperties& stone_on_box, double height, BoxWalls& walls);

// A rectangle over the whole box, facing down, with its underside at `height` [m].
dem::Wall box_plate(const std::string& name, const BoxParameters& box,
                    const dem::ContactProperties& stone_on_box, double height);
} // namespace interlock::coupling
