// The section Stones, which several experiments share.
#pragma once

#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"
#include "coupling/parameters/stone_parameters.h"

namespace interlock::coupling
{
// Declares every member of `stones`, which must outlive the table, in the section Stones.
void declare_stones(ParameterTable& table, StoneParameters& stones);

// Adds what contradicts each other or the disk. Looks at the folder of scans, changes nothing,
// never throws.
void check_stones(const StoneParameters& stones, ParameterProblems& problems);
} // namespace interlock::coupling
