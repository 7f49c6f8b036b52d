// The options of `interlock clump`, as they are typed and as they are used.
#pragma once

#include "apps/clump_files.h"
#include "dem/generator/clump_generator.h"
#include "dem/scans/stone_file.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <vector>

namespace interlock::apps
{
struct ClumpOptions {
  ClumpArguments files;
  std::string scheme = "mesh", radius = "surface", order = "random", unit = "m", table;
  std::optional<double> d_min, r_min;                       // [m]
  double target_volume_error = 0, target_inertia_error = 0; // [%]
  bool flip = false, accept_crossings = false, unusual = false;
  std::optional<double> density; // [kg/m3]
  std::vector<int> compared;     // numbers of spheres for both orders
  dem::ClumpParameters parameters;
};

void add_clump_options(CLI::App& command, ClumpOptions& options);

// `--format csv vtk stone.stl`: moves the words that are files or folders to the stones.
void take_stones_from_formats(ClumpArguments& files);

// In SI units and shares. Throws InputError, in the unit that was typed, when one of them is
// missing or out of range, the density and the unit of the stones included.
dem::ClumpParameters clump_parameters(const ClumpOptions& options);

dem::StoneFileOptions file_options(const ClumpOptions& options);
} // namespace interlock::apps
