// Which stone carries a pull that stones should share: squeezed between two things that do not
// give.
#pragma once

#include "coupling/loop/world.h"

#include <string>

namespace interlock::coupling
{
// Of the stones with a contact that overlaps by more than `bound` [m], the one whose second
// strongest partner pushes most: "stone 118 (centre at x = 12, y = 80, z = 95 mm) between
// transverse rib 2 (40.2 kN) and the wall 'front above slot' (39.8 kN)". Partners are lines of
// ribs, walls and stones, each with the force of all its contacts with the stone. Empty when there
// is none. Ribs are counted from the front, longitudinal ones from y = 0. Call it between
// compute_forces and move; collective, with the same answer on all ranks.
std::string wedged_stone(const World& world, double bound);
} // namespace interlock::coupling
