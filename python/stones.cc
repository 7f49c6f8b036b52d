#include "python/stones.h"

#include "apps/clump_making.h"
#include "apps/clump_warnings.h"
#include "dem/input_error.h"
#include "dem/stones/stone_form.h"
#include "dem/stones/synthetic_stone.h"
#include "python/arrays.h"

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace interlock::python
{
namespace
{
dem::StoneStyle style_of(const py::dict& words)
{
  dem::StoneStyle style;
  for (const auto& [key, value] : words) {
    const auto name = py::cast<std::string>(key);
    const auto is = [&](const char* known, auto& member) {
      if (name != known) return false;
      member = py::cast<std::decay_t<decltype(member)>>(value);
      return true;
    };
    if (!(is("flatness", style.flatness) || is("flatness_spread", style.flatness_spread) ||
          is("elongation", style.elongation) || is("elongation_spread", style.elongation_spread) ||
          is("faces", style.faces) || is("edge_wear", style.edge_wear) ||
          is("scars", style.scars) || is("scar_depth", style.scar_depth) ||
          is("steps", style.steps) || is("roughness", style.roughness) ||
          is("roughness_exponent", style.roughness_exponent) || is("spacing", style.spacing)))
      throw py::type_error("stones() has no argument \"" + name + "\"");
  }
  return style;
}

py::dict describe(const dem::TriangleMesh& mesh)
{
  const dem::StoneForm form = dem::stone_form(mesh);
  py::dict stone;
  stone["vertices"] = array_of(mesh.vertices);
  stone["triangles"] = array_of(mesh.triangles);
  stone["longest"] = form.size.longest;
  stone["intermediate"] = form.size.intermediate;
  stone["shortest"] = form.size.shortest;
  stone["sieve"] = form.size.sieve;
  stone["sphericity"] = form.size.sphericity;
  stone["convexity"] = form.convexity;
  stone["angularity"] = form.angularity;
  stone["volume"] = form.volume;
  return stone;
}

py::list make_stones(int count, std::uint64_t seed, const py::dict& words)
{
  const dem::StoneStyle style = style_of(words);
  std::vector<dem::TriangleMesh> stones;
  {
    py::gil_scoped_release others_may_run;
    stones = dem::make_stones(count, seed, style);
  }
  py::list result;
  for (const dem::TriangleMesh& stone : stones) result.append(describe(stone));
  return result;
}

// The clump as its file holds it (dem/bodies/clump_shape.h), and the report about it.
py::dict describe(const apps::ClumpResult& result)
{
  const std::vector<dem::Sphere>& spheres = result.shape.spheres;
  py::array_t<double> rows({py::ssize_t(spheres.size()), py::ssize_t(4)});
  auto number = rows.mutable_unchecked<2>();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (int k = 0; k < 3; ++k) number(i, k) = spheres[i].centre[k];
    number(i, 3) = spheres[i].radius;
  }
  const dem::Vector3& inertia = result.shape.unit_inertia;
  const dem::Vector3& origin = result.report.origin;
  const dem::Quaternion& turn = result.report.rotation;
  py::dict clump;
  clump["name"] = result.shape.name;
  clump["spheres"] = rows;
  clump["volume"] = result.shape.volume;
  clump["unit_inertia"] = std::vector<double>{inertia[0], inertia[1], inertia[2]};
  clump["centre"] = std::vector<double>{origin[0], origin[1], origin[2]};
  clump["rotation"] = std::vector<double>{turn.x(), turn.y(), turn.z(), turn.w()};
  clump["report"] = clump_json(result).dump();
  clump["warnings"] = missed_targets(result) + clump_warnings(result);
  clump["text"] = dem::clump_shape_text(result.shape);
  return clump;
}

apps::ClumpOptions options_of(const py::dict& words)
{
  apps::ClumpOptions options;
  const auto take = [&](const char* name, auto& member) {
    if (words.contains(name)) member = py::cast<std::decay_t<decltype(member)>>(words[name]);
  };
  take("d_min", options.d_min);
  take("r_min", options.r_min);
  take("p_max", options.parameters.p_max);
  take("max_spheres", options.parameters.max_spheres);
  take("bulge", options.parameters.bulge);
  take("seed", options.parameters.seed);
  take("order", options.order);
  take("touching_radius", options.radius);
  take("mass_properties", options.scheme);
  take("target_volume_error", options.target_volume_error);
  take("target_inertia_error", options.target_inertia_error);
  take("density", options.density);
  take("unit", options.unit);
  take("flip", options.flip);
  take("accept_crossings", options.accept_crossings);
  take("unusual", options.unusual);
  return options;
}

py::dict clump_of_file(const std::string& file, const std::string& name, const py::dict& words)
{
  const apps::ClumpOptions options = options_of(words);
  apps::ClumpResult result;
  {
    py::gil_scoped_release others_may_run;
    result = apps::clump_of_file(file, name, options, apps::clump_parameters(options));
  }
  return describe(result);
}

py::dict clump_of_arrays(const py::array_t<double, py::array::c_style>& vertices,
                         const py::array_t<int, py::array::c_style>& triangles,
                         const std::string& name, const py::dict& words)
{
  const apps::ClumpOptions options = options_of(words);
  dem::TriangleMesh mesh = mesh_of(vertices, triangles);
  apps::ClumpResult result;
  {
    py::gil_scoped_release others_may_run;
    result = apps::clump_of_surface(std::move(mesh), name, options, clump_parameters(options));
  }
  return describe(result);
}
} // namespace

void add_stones(py::module_& module)
{
  module.def("make_stones", &make_stones);
  module.def("clump_of_file", &clump_of_file);
  module.def("clump_of_arrays", &clump_of_arrays);
  module.def("write_stl",
             [](const std::string& file, const py::array_t<double, py::array::c_style>& vertices,
                const py::array_t<int, py::array::c_style>& triangles) {
               dem::write_stl(file, mesh_of(vertices, triangles));
             });
}
} // namespace interlock::python
