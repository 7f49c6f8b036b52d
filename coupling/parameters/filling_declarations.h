// The section Filling, which several experiments share.
#pragma once

#include "coupling/parameters/filling_parameters.h"
#include "coupling/parameters/parameter_table.h"

namespace interlock::coupling
{
// Opens the section Filling and declares what every filling needs; an experiment adds entries of
// its own behind it. `filling` must outlive the table.
void declare_filling(ParameterTable& table, FillingParameters& filling);
} // namespace interlock::coupling
