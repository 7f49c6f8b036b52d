// What a single entry's range cannot tell: parameters that contradict each other or the disk.
#pragma once

#include "coupling/pull_out_parameters.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
struct ParameterProblem {
  std::string entry;    // "Section/Name" of the entry to change first
  std::string sentence; // full sentence with the values and what is allowed
};

// All contradictions, in the order of the sections; empty when the parameters can be run. Every
// number must be inside its own range already. Looks at the stones folder, changes nothing, never
// throws.
std::vector<ParameterProblem> check_parameters(const PullOutParameters& parameters);
} // namespace interlock::coupling
