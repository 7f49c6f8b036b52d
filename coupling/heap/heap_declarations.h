// The entries of a parameter file with `Experiment = heap`, and what they must not contradict.
#pragma once

#include "coupling/heap/heap_parameters.h"
#include "coupling/parameters/parameter_problems.h"
#include "coupling/parameters/parameter_table.h"

namespace interlock::coupling
{
// Declares every member of `parameters` once, in the sections Stones, Contact, Drop, Measures, Time
// and Output, and Gravity at the top level. `parameters` must outlive the table.
void declare_heap(ParameterTable& table, HeapParameters& parameters);

// All contradictions, in the order of the sections; empty when the parameters can be run. Every
// number must be inside its own range already. Looks at the stones folder, changes nothing, never
// throws.
std::vector<ParameterProblem> check_heap(const HeapParameters& parameters);
} // namespace interlock::coupling
