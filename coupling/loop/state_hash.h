// A number that changes when any digit of the state changes: proof that two runs are the same.
#pragma once

#include "coupling/loop/world.h"

#include <cstdint>

namespace interlock::coupling
{
// Of everything in the field list of a world: clumps, walls, what contacts remember, lattice,
// energy sums, clock. Caches are in no field list, so lists, skins and restarts do not change it.
std::uint64_t state_hash(const World& world);
} // namespace interlock::coupling
