// How well clumps stand for their stones.
#pragma once

#include "coupling/stones/stone_shapes.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
// A clump whose union of spheres is off by more of its stone's volume is warned of [-].
constexpr double largest_volume_error = 0.1;

// "volume of the spheres -8 to -2 % of that of their stones, all in one piece", for a log.
std::string quality_text(const std::vector<Stone>& stones);

// One full sentence for each kind of fault, with the settings that mend it: clumps in pieces,
// volume errors above the bound. Empty for good clumps.
std::vector<std::string> quality_warnings(const std::vector<Stone>& stones);
} // namespace interlock::coupling
