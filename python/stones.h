// Synthetic stones, and stones made into clumps.
#pragma once

#include <pybind11/pybind11.h>

namespace interlock::python
{
void add_stones(pybind11::module_& module);
} // namespace interlock::python
