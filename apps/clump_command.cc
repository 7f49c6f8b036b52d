#include "apps/clump_command.h"

#include "apps/clump_table.h"
#include "apps/octahedron_command.h"
#include "coupling/atomic_file.h"
#include "dem/export/clump_export.h"
#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/scans/cloud_cells.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> stones, formats;
  std::string scheme = "mesh", radius = "surface", unit = "m", output, report, table;
  double d_min = -1, r_min = -1;                            // negative: not given [m]
  double target_volume_error = 0, target_inertia_error = 0; // [%]
  bool flip = false, accept_crossings = false;
  double density = 0; // [kg/m3]
  dem::ClumpParameters parameters;
};

dem::ClumpParameters clump_parameters(const Options& options)
{
  for (const auto& [name, value] :
       {std::pair("--d-min", options.d_min), {"--r-min", options.r_min}})
    if (value < 0)
      throw InputError(std::string("The option ") + name +
                       " is missing or negative, but must be a length of 0 m or more.");
  if (options.density < 0) throw InputError("The density is negative, but must be above 0 kg/m3.");
  for (const std::string& format : options.formats) dem::clump_format(format); // throws
  if (!options.formats.empty() && options.density == 0)
    throw InputError("Other codes need masses: give --density in kg/m3 with --format.");
  dem::ClumpParameters parameters = options.parameters;
  parameters.d_min = options.d_min;
  parameters.r_min = options.r_min;
  parameters.mass_scheme = dem::mass_scheme(options.scheme);
  parameters.touching_radius = dem::touching_radius(options.radius);
  parameters.target_volume_error = options.target_volume_error / 100;
  parameters.target_inertia_error = options.target_inertia_error / 100;
  return parameters;
}

bool is_stone_file(const fs::path& path)
{
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".stl" || extension == ".ply" || extension == ".obj" || extension == ".xyz";
}

dem::StoneFileOptions file_options(const Options& options)
{
  dem::StoneFileOptions file;
  file.length_unit = dem::length_of_unit(options.unit);
  file.flip = options.flip;
  file.accept_crossings = options.accept_crossings;
  return file;
}

// Files as they are; of folders the stones in them, by name.
std::vector<std::string> stone_files(const std::vector<std::string>& arguments)
{
  std::vector<std::string> files;
  for (const std::string& argument : arguments) {
    if (!fs::is_directory(argument)) {
      files.push_back(argument);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : fs::directory_iterator(argument))
      if (is_stone_file(entry.path())) inside.push_back(entry.path().string());
    if (inside.empty())
      throw InputError("The folder '" + argument + "' has no .stl, .ply, .obj or .xyz file in it.");
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

void make_clump_of_mesh(const Options& options, ClumpResult& result)
{
  const dem::TriangleMesh stone =
      dem::read_stone_mesh(result.file, file_options(options), &result.mesh);
  result.nodes = stone.vertices.size();
  result.facets = stone.triangles.size();
  result.size = dem::stone_size(stone);
  result.volume = dem::mass_properties(stone).volume;
  result.shape = dem::make_clump(stone, result.parameters, &result.report);
}

void make_clump_of_cloud(const Options& options, ClumpResult& result)
{
  const dem::PointCloud stone =
      dem::read_point_cloud(result.file, file_options(options), &result.cloud);
  const dem::CloudProperties properties = dem::cloud_properties(stone);
  result.parameters.touching_radius = dem::TouchingRadius::nodes; // there are no facets
  result.nodes = stone.points.size();
  result.size = dem::stone_size(stone.points, properties.body, properties.area);
  result.volume = properties.body.volume;
  result.shape = dem::make_clump(stone, properties.body, result.parameters, &result.report);
}

ClumpResult make_clump(const std::string& file, const Options& options,
                       const dem::ClumpParameters& parameters)
{
  ClumpResult result;
  result.file = file;
  result.name = fs::path(file).stem().string();
  result.density = options.density;
  result.parameters = parameters;
  if (dem::is_point_cloud(file))
    make_clump_of_cloud(options, result);
  else
    make_clump_of_mesh(options, result);
  result.shape.name = result.name;
  return result;
}

// The clump file, and one for each other code.
void write_clump(const std::string& path, const ClumpResult& result, const Options& options)
{
  dem::write_clump_shape(path, result.shape);
  for (const std::string& format : options.formats)
    dem::export_clump(dem::clump_export_path(path, dem::clump_format(format)), result.shape,
                      dem::clump_format(format), options.density);
}

void create_folder(const fs::path& folder)
{
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (!folder.empty() && !fs::is_directory(folder, error))
    throw InputError("The folder '" + folder.string() + "' for the clumps cannot be created.");
}

void write_report(const std::string& path, const std::vector<ClumpResult>& results)
{
  nlohmann::ordered_json report;
  const dem::ClumpParameters& p = results.front().parameters;
  report["version"] = INTERLOCK_VERSION;
  report["parameters"] = {
      {"d_min_m", p.d_min},
      {"r_min_m", p.r_min},
      {"p_max_percent", p.p_max},
      {"max_spheres", p.max_spheres},
      {"target_volume_error", p.target_volume_error},
      {"target_inertia_error", p.target_inertia_error},
      {"touching_radius", p.touching_radius == dem::TouchingRadius::surface ? "surface" : "nodes"},
      {"seed", p.seed}};
  for (const ClumpResult& result : results) report["clumps"].push_back(clump_json(result));
  coupling::write_atomically(path, report.dump(2) + "\n");
  std::printf("Report: '%s'\n", path.c_str());
}

void make_one(const std::string& file, const Options& options,
              const dem::ClumpParameters& parameters)
{
  const ClumpResult result = make_clump(file, options, parameters);
  print_clump(result);
  std::printf("%s", missed_targets(result).c_str());
  const std::string clump = options.output.empty() ? result.name + ".clump.json" : options.output;
  create_folder(fs::path(clump).parent_path());
  write_clump(clump, result, options);
  std::printf("Clump: '%s'\n", clump.c_str());
  for (const std::string& format : options.formats)
    std::printf("For %s: '%s'\n", format.c_str(),
                dem::clump_export_path(clump, dem::clump_format(format)).c_str());
  const std::string beside = (fs::path(clump).parent_path() / result.name).string();
  write_report(options.report.empty() ? beside + ".report.json" : options.report, {result});
}

void make_many(const std::vector<std::string>& files, const Options& options,
               const dem::ClumpParameters& parameters)
{
  if (options.output.empty())
    throw InputError("Several stones need a folder for their clumps: --output FOLDER.");
  create_folder(options.output);
  print_clump_table_head();
  std::vector<ClumpResult> results;
  for (const std::string& file : files) {
    results.push_back(make_clump(file, options, parameters));
    print_clump_table_row(results.back());
    std::fflush(stdout); // a row as soon as its clump is there
    write_clump((fs::path(options.output) / (results.back().name + ".clump.json")).string(),
                results.back(), options);
  }
  print_clump_table_means(results);
  for (const ClumpResult& result : results)
    std::printf("%s%s", remarks(result).c_str(), missed_targets(result).c_str());
  std::printf("%zu clumps in '%s'\n", results.size(), options.output.c_str());
  write_report(options.report.empty() ? (fs::path(options.output) / "clumps.report.json").string()
                                      : options.report,
               results);
}

void make(const Options& options)
{
  if (!options.table.empty()) return print_published_table(options.table);
  const dem::ClumpParameters parameters = clump_parameters(options);
  const std::vector<std::string> files = stone_files(options.stones);
  if (files.empty()) throw InputError("No stone is given: interlock clump STONE... (--help).");
  if (files.size() == 1)
    make_one(files.front(), options, parameters);
  else
    make_many(files, options, parameters);
}
} // namespace

void add_clump_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("clump", "Turn closed stones into clumps of spheres");
  dem::ClumpParameters& p = options->parameters;
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command->add_option(name, value, text);
  };
  add("stones", options->stones,
      "Stones: closed meshes (.stl, .ply, .obj), clouds of points with normals (.ply, .xyz), or "
      "folders "
      "of them");
  add("--d-min", options->d_min, "Nodes nearer to a sphere's surface get no sphere [m]");
  add("--r-min", options->r_min, "Smaller spheres are rejected [m]");
  add("--p-max", p.p_max, "Largest share of the nodes to be used [%]")->capture_default_str();
  add("--max-spheres", p.max_spheres, "Stop at this number of spheres (0: no limit)");
  add("--target-volume-error", options->target_volume_error,
      "Stop when the spheres' union has the stone's volume to within this [%]");
  add("--target-inertia-error", options->target_inertia_error,
      "Stop when the principal moments are off by this on average [%]");
  add("--touching-radius", options->radius,
      "How far balls grow: to the surface (facets), or to nodes (the paper's)")
      ->capture_default_str();
  add("--seed", p.seed, "Seed of the order of the nodes")->capture_default_str();
  add("--mass-properties", options->scheme, "Centre and inertia: uniform, equal-mass or mesh")
      ->capture_default_str();
  add("--density", options->density, "Density of the rock, for masses [kg/m3]");
  add("--unit", options->unit, "Length unit of the stones: m, cm, mm or inch")
      ->capture_default_str();
  command->add_flag("--flip", options->flip, "The stones are inside out: turn them round");
  command->add_flag("--accept-crossings", options->accept_crossings,
                    "Take surfaces that cross themselves");
  add("-o,--output", options->output,
      "Clump file (default: the stone's name with .clump.json, here); folder for several stones");
  add("--format", options->formats,
      "Also write the clump for other codes, beside the clump file: lammps, liggghts, yade, "
      "mercury, "
      "pfc, csv, vtk; needs --density")
      ->delimiter(',');
  add("--report", options->report, "Report file (default: NAME.report.json beside the clump)");
  add("--table", options->table,
      "Instead of all this: print a published table beside ours (octahedron)");
  command->callback([options] { make(*options); });
}
} // namespace interlock::apps
