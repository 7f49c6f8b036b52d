// The parameter file of a laboratory test of a geogrid.
#pragma once

#include "coupling/laboratory/laboratory_parameters.h"
#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"

#include <vector>

namespace interlock::coupling
{
// Declares every member of `parameters`, which must outlive the table.
void declare_laboratory(ParameterTable& table, LaboratoryParameters& parameters);

// What no single entry's range can tell. Empty: fine.
std::vector<ParameterProblem> check_laboratory(const LaboratoryParameters& parameters);
} // namespace interlock::coupling
