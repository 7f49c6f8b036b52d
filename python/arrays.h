// NumPy arrays of what C++ holds.
#pragma once

#include "dem/bodies/component_arrays.h"
#include "dem/meshes/triangle_mesh.h"

#include <pybind11/numpy.h>

#include <vector>

namespace interlock::python
{
namespace py = pybind11;

// Read-only arrays over memory that `owner` keeps alive; nothing is copied. Shapes: (n,) of
// numbers, (n, 3) of vectors, (n, 4) of quaternions (x, y, z, w).
py::array view(const dem::ScalarField& field, py::handle owner);
py::array view(const dem::VectorField& field, py::handle owner);
py::array view(const dem::QuaternionField& field, py::handle owner);
py::array view(const std::vector<std::int64_t>& values, py::handle owner);
py::array view(const std::vector<int>& values, py::handle owner);

// Copies, which belong to Python alone: (n, 3) [m], and (m, 3) indices of 32 bits.
py::array array_of(const std::vector<dem::Vector3>& points);
py::array array_of(const std::vector<std::array<int, 3>>& triangles);

// The way back. Throws InputError when an array has another shape.
dem::TriangleMesh mesh_of(const py::array_t<double, py::array::c_style>& vertices,
                          const py::array_t<int, py::array::c_style>& triangles);
} // namespace interlock::python
