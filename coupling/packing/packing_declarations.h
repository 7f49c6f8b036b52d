// The entries of a parameter file with `Experiment = packing`, and what they must not contradict.
#pragma once

#include "coupling/packing/packing_parameters.h"
#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"

namespace interlock::coupling
{
// Declares every member of `parameters` once, in the sections Packing, Contact, Time, Neighbour
// lists and Output, and Gravity at the top level. `parameters` must outlive the table.
void declare_packing(ParameterTable& table, PackingParameters& parameters);

// All contradictions, in the order of the sections; empty when the parameters can be run. Every
// number must be inside its own range already. Looks at the disk, changes nothing, never throws.
std::vector<ParameterProblem> check_packing(const PackingParameters& parameters);
} // namespace interlock::coupling
