// What the single entries of a pull-out cannot tell.
#pragma once

#include "coupling/parameters/parameter_problems.h"
#include "coupling/pull_out/pull_out_parameters.h"

namespace interlock::coupling
{
// All contradictions, in the order of the sections; empty when the parameters can be run. Every
// number must be inside its own range already. Looks at the stones folder, changes nothing, never
// throws.
std::vector<ParameterProblem> check_pull_out(const PullOutParameters& parameters);
} // namespace interlock::coupling
