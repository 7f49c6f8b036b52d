// Cases: parameter files with changes, their entries, what they would take, their runs.
#pragma once

#include <pybind11/pybind11.h>

namespace interlock::python
{
void add_cases(pybind11::module_& module);
} // namespace interlock::python
