#include "coupling/parameters/stone_declarations.h"

#include "dem/scans/stone_names.h"

#include <algorithm>
#include <filesystem>

namespace interlock::coupling
{
namespace
{
namespace fs = std::filesystem;

bool is_scan(const fs::directory_entry& entry)
{
  return dem::is_stone_file(entry, dem::mesh_endings);
}
} // namespace

void declare_stones(ParameterTable& table, StoneParameters& stones)
{
  table.open_section("Stones");
  table.offer_folder(
      "Folder", stones.folder,
      "Folder of closed surface scans (STL, PLY, OBJ), or of clumps made by interlock clump "
      "(*.clump.json), relative to this file; empty: synthetic stones.");
  // 0 stands for `not given`: a wrong guess would make stones of the size of a house.
  table.offer("Length unit", stones.length_unit, 0, not_negative,
              "Length of one unit of the scans, 0.001 for millimetres; needed with a folder. [m]");
  table.offer("Count", stones.count, 41, {1, 100000, true},
              "Number of different synthetic stones. [-]");
  table.offer_seed("Seed", stones.seed,
                   "Seed of the synthetic stones and of the order of the clump generator. [-]");
  table.require("Density", stones.density, positive, "Density of the rock. [kg/m3]");
  table.require(
      "D min", stones.d_min, not_negative,
      "Clump generator: a surface node nearer than this to a sphere gets no sphere of its "
      "own. [m]");
  table.require("R min", stones.r_min, not_negative,
                "Clump generator: spheres of a smaller radius are rejected. [m]");
  table.require("P max", stones.p_max, {0, 100, false},
                "Clump generator: stop when this share of the surface nodes has been used. [%]");
  table.offer("Max spheres", stones.max_spheres, 0, {0, 100000, true},
              "Clump generator: largest number of spheres in a clump; 0: no limit. [-]");
  table.offer_choice("Mass properties", stones.mass_properties, "mesh",
                     {"uniform", "equal-mass", "mesh"},
                     "Mass, centre and inertia of a clump: spheres of the same density, spheres of "
                     "the same mass, or exactly those of the closed surface.");
}

void check_stones(const StoneParameters& stones, ParameterProblems& problems)
{
  if (stones.folder.empty()) return;
  std::error_code error;
  const fs::directory_iterator files(stones.folder, error);
  if (error)
    problems.add("Stones/Folder", "The folder of scans \"", stones.folder,
                 "\" cannot be read: ", error.message(), ".");
  const bool scans = !error && std::any_of(begin(files), end(files), is_scan);
  const bool clumps = !error && !dem::clump_files(stones.folder).empty();
  if (!error && !scans && !clumps)
    problems.add(
        "Stones/Folder", "The folder of scans \"", stones.folder,
        "\" holds no file that ends with .stl, .ply, .obj or .clump.json (names that start "
        "with a dot do not count).");
  if (scans && clumps)
    problems.add("Stones/Folder", "The folder \"", stones.folder,
                 "\" holds scans and clumps; move one of them elsewhere.");
  if (clumps) return; // in metres
  if (stones.length_unit <= 0)
    problems.add("Stones/Length unit", "The length of one unit of the scans must be given with a "
                                       "folder of scans, for example 0.001 m for millimetres.");
}
} // namespace interlock::coupling
