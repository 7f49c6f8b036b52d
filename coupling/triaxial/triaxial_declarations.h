// The entries of a parameter file with `Experiment = triaxial`, and what they must not contradict.
#pragma once

#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"
#include "coupling/triaxial/triaxial_parameters.h"

namespace interlock::coupling
{
// Declares every member of `parameters` once. `parameters` must outlive the table.
void declare_triaxial(ParameterTable& table, TriaxialParameters& parameters);

// All contradictions, in the order of the sections; empty when the parameters can be run. Every
// number must be inside its own range already. Looks at the disk, changes nothing, never throws.
std::vector<ParameterProblem> check_triaxial(const TriaxialParameters& parameters);
} // namespace interlock::coupling
