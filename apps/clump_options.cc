#include "apps/clump_options.h"

#include "apps/seed_option.h"
#include "coupling/parameters/usual_ranges.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace interlock::apps
{
namespace
{
// Asks about values in what is most likely another unit; 0 stands for `none`.
void check_usual(const ClumpOptions& options, const char* option, double value, const char* unit)
{
  const std::string why = coupling::why_unusual(option, value, unit);
  if (!why.empty() && !options.unusual)
    throw InputError(
        fmt::format("The option {} is {:g} {}, {}. With --unusual it is taken as it is.", option,
                    value, unit, why));
}

void check_density(const ClumpOptions& options)
{
  for (const std::string& format : options.files.formats) dem::clump_format(format); // throws
  if (!options.density && !options.files.formats.empty())
    throw InputError("Other codes need masses: give --density in kg/m3 with --format.");
  if (!options.density) return;
  if (!(*options.density > 0) || std::isinf(*options.density))
    throw InputError(fmt::format("The option --density is {:g} kg/m3, but must be greater than 0.",
                                 *options.density));
  check_usual(options, "--density", *options.density, "kg/m3");
}

// As it was typed, in per cent.
void check_target(const char* option, double percent)
{
  if (percent >= 0 && percent < 100) return;
  std::ostringstream text;
  text << "The option " << option << " is " << percent
       << " %, but must be 0 % (no target) or more, and below 100 %.";
  throw InputError(text.str());
}
} // namespace

dem::ClumpParameters clump_parameters(const ClumpOptions& options)
{
  dem::ClumpParameters parameters = options.parameters;
  parameters.sphere_order = dem::sphere_order(options.order);
  // By gain, spheres that add little come late: any d_min and r_min will do.
  const double missing = parameters.sphere_order == dem::SphereOrder::gain ? 0 : -1;
  parameters.d_min = options.d_min.value_or(missing);
  parameters.r_min = options.r_min.value_or(missing);
  for (const auto& [name, value] :
       {std::pair("--d-min", parameters.d_min), {"--r-min", parameters.r_min}})
    if (value < 0)
      throw InputError(std::string("The option ") + name +
                       " is missing or negative, but must be a length of 0 m or more.");
  check_usual(options, "--d-min", parameters.d_min, "m");
  check_usual(options, "--r-min", parameters.r_min, "m");
  check_usual(options, "--bulge", parameters.bulge, "m");
  check_density(options);
  check_target("--target-volume-error", options.target_volume_error);
  check_target("--target-inertia-error", options.target_inertia_error);
  parameters.mass_scheme = dem::mass_scheme(options.scheme);
  parameters.touching_radius = dem::touching_radius(options.radius);
  parameters.target_volume_error = options.target_volume_error / 100;
  parameters.target_inertia_error = options.target_inertia_error / 100;
  dem::check_parameters(parameters);
  dem::length_of_unit(options.unit); // throws
  return parameters;
}

void take_stones_from_formats(ClumpArguments& files)
{
  const auto is_stone = [](const std::string& word) {
    std::error_code error;
    return word.find_first_of("./") != std::string::npos || std::filesystem::exists(word, error);
  };
  const auto first =
      std::stable_partition(files.formats.begin(), files.formats.end(),
                            [&](const std::string& word) { return !is_stone(word); });
  files.stones.insert(files.stones.end(), first, files.formats.end());
  files.formats.erase(first, files.formats.end());
}

dem::StoneFileOptions file_options(const ClumpOptions& options)
{
  dem::StoneFileOptions file;
  file.length_unit = dem::length_of_unit(options.unit);
  file.flip = options.flip;
  file.accept_crossings = options.accept_crossings;
  return file;
}

void add_clump_options(CLI::App& command, ClumpOptions& options)
{
  dem::ClumpParameters& p = options.parameters;
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text);
  };
  ClumpArguments& files = options.files;
  add("stones", files.stones,
      "Stones: closed meshes (.stl, .ply, .obj), clouds of points with normals (.ply, .xyz), or "
      "folders of them");
  add("--sphere-order", options.order,
      "Which sphere comes next: random (nodes as they are drawn, the paper's), or gain (the one "
      "that adds most to the shape; --d-min and --r-min may then be left out)")
      ->capture_default_str();
  add("--d-min", options.d_min, "Nodes nearer to a sphere's surface get no sphere [m]");
  add("--r-min", options.r_min, "Smaller spheres are rejected [m]");
  add("--bulge", p.bulge,
      "How far spheres may stand out of the surface so that their union has the stone's volume [m]")
      ->capture_default_str();
  add("--p-max", p.p_max, "Largest share of the nodes to be used [%]")->capture_default_str();
  add("--spheres,--max-spheres", p.max_spheres, "Stop at this number of spheres (0: no limit)");
  add("--target-volume-error", options.target_volume_error,
      "Stop when the spheres' union has the stone's volume to within this [%]");
  add("--target-inertia-error", options.target_inertia_error,
      "Stop when the principal moments are off by this on average [%]");
  add("--touching-radius", options.radius,
      "How far balls grow: to the surface (facets), or to nodes (the paper's)")
      ->capture_default_str();
  add_seed_option(command, p.seed, "Seed of the order of the nodes");
  add("--mass-properties", options.scheme, "Centre and inertia: uniform, equal-mass or mesh")
      ->capture_default_str();
  add("--density", options.density, "Density of the rock, for masses [kg/m3]");
  add("--unit", options.unit, "Length unit of the stones: m, cm, mm or inch")
      ->capture_default_str();
  command.add_flag("--flip", options.flip, "The stones are inside out: turn them round");
  command.add_flag("--accept-crossings", options.accept_crossings,
                   "Take surfaces that cross themselves");
  add("-o,--output", files.output,
      "Clump file (default: the stone's name with .clump.json, here), or folder for it; folder for "
      "several stones");
  // Takes the stones behind it, too; take_stones_from_formats gives them back.
  add("--format", files.formats,
      "Also write the clump for other codes, beside the clump file: lammps, liggghts, yade, "
      "mercury, pfc, csv, vtk; needs --density; all but csv and vtk get a name of letters, digits "
      "and _")
      ->delimiter(',');
  command.add_flag("--unusual", options.unusual,
                   "Take values that are far from those of ballast as they are");
  add("--compare-orders", options.compared,
      "Also tell how good clumps of these numbers of spheres are in both orders, as means over the "
      "stones: --compare-orders 20,55,150")
      ->delimiter(',')
      ->check(CLI::Range(1, 100000))
      ->allow_extra_args(false);
  add("--report", files.report,
      "Report file (default: the clump file's name with .report.json; several stones: "
      "clumps.report.json in their folder)");
  add("--table", options.table,
      "Instead of all this: print a published table beside ours (octahedron)");
}
} // namespace interlock::apps
