// The entries of a pull-out parameter file.
#pragma once

#include "coupling/parameters/parameter_table.h"
#include "coupling/pull_out/pull_out_parameters.h"

namespace interlock::coupling
{
// Declares every member of `parameters` once, in the sections Stones, Box, Contact, Geogrid,
// Filling, Surcharge, Pull, Time and Output, and Gravity at the top level. Whatever decides the
// physics must be given; seeds, numerical settings and output have defaults. `parameters` must
// outlive the table.
void declare_pull_out(ParameterTable& table, PullOutParameters& parameters);
} // namespace interlock::coupling
