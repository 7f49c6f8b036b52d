#include "python/arrays.h"

#include "dem/input_error.h"

namespace interlock::python
{
namespace
{
constexpr py::ssize_t number_size = sizeof(double);

py::array read_only(py::array array)
{
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

// Rows of components lie one behind the other: an array whose second axis goes from row to row.
template <class Field> py::array view_of_rows(const Field& field, int rows, py::handle owner)
{
  const py::ssize_t n = field.size();
  if (n == 0) return py::array_t<double>(std::vector<py::ssize_t>{0, rows});
  const py::ssize_t row_size = number_size * (field.row(1) - field.row(0));
  return read_only(
      py::array_t<double>({n, py::ssize_t(rows)}, {number_size, row_size}, field.row(0), owner));
}

template <class T> py::array view_of_vector(const std::vector<T>& values, py::handle owner)
{
  if (values.empty()) return py::array_t<T>(0);
  return read_only(py::array_t<T>(values.size(), values.data(), owner));
}

std::string shape_text(const py::array& array)
{
  return py::str(py::cast<py::object>(array).attr("shape"));
}
} // namespace

py::array view(const dem::ScalarField& field, py::handle owner)
{
  if (field.size() == 0) return py::array_t<double>(0);
  return read_only(py::array_t<double>(field.size(), field.row(0), owner));
}

py::array view(const dem::VectorField& field, py::handle owner)
{
  return view_of_rows(field, 3, owner);
}

py::array view(const dem::QuaternionField& field, py::handle owner)
{
  return view_of_rows(field, 4, owner);
}

py::array view(const std::vector<std::int64_t>& values, py::handle owner)
{
  return view_of_vector(values, owner);
}

py::array view(const std::vector<int>& values, py::handle owner)
{
  return view_of_vector(values, owner);
}

py::array array_of(const std::vector<dem::Vector3>& points)
{
  py::array_t<double> array({py::ssize_t(points.size()), py::ssize_t(3)});
  auto rows = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) rows(i, k) = points[i][k];
  return std::move(array);
}

py::array array_of(const std::vector<std::array<int, 3>>& triangles)
{
  py::array_t<int> array({py::ssize_t(triangles.size()), py::ssize_t(3)});
  auto rows = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) rows(i, k) = triangles[i][k];
  return std::move(array);
}

dem::TriangleMesh mesh_of(const py::array_t<double, py::array::c_style>& vertices,
                          const py::array_t<int, py::array::c_style>& triangles)
{
  const auto check = [](const py::array& array, const char* name) {
    if (array.ndim() != 2 || array.shape(1) != 3)
      throw InputError(std::string("The array \"") + name + "\" has the shape " +
                       shape_text(array) + ", but must have n rows of 3.");
  };
  check(vertices, "vertices");
  check(triangles, "triangles");
  dem::TriangleMesh mesh;
  const auto points = vertices.unchecked<2>();
  for (py::ssize_t i = 0; i < points.shape(0); ++i)
    mesh.vertices.emplace_back(points(i, 0), points(i, 1), points(i, 2));
  const auto corners = triangles.unchecked<2>();
  for (py::ssize_t i = 0; i < corners.shape(0); ++i)
    mesh.triangles.push_back({corners(i, 0), corners(i, 1), corners(i, 2)});
  return mesh;
}
} // namespace interlock::python
