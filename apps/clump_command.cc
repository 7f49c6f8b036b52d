#include "apps/clump_command.h"

#include "apps/clump_files.h"
#include "apps/clump_table.h"
#include "apps/clump_writing.h"
#include "apps/interruption.h"
#include "apps/octahedron_command.h"
#include "apps/seed_option.h"
#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/scans/cloud_cells.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

struct Options {
  ClumpArguments files;
  std::string scheme = "mesh", radius = "surface", unit = "m", table;
  double d_min = -1, r_min = -1;                            // negative: not given [m]
  double target_volume_error = 0, target_inertia_error = 0; // [%]
  bool flip = false, accept_crossings = false;
  std::optional<double> density; // [kg/m3]
  dem::ClumpParameters parameters;
};

// Of rocks and metals; keeps g/cm3 and slips of the keyboard out [kg/m3].
constexpr double smallest_density = 100, largest_density = 30000;

void check_density(const Options& options)
{
  for (const std::string& format : options.files.formats) dem::clump_format(format); // throws
  if (!options.density && !options.files.formats.empty())
    throw InputError("Other codes need masses: give --density in kg/m3 with --format.");
  if (!options.density ||
      (*options.density >= smallest_density && *options.density <= largest_density))
    return;
  std::ostringstream text;
  text << "The option --density is " << *options.density << " kg/m3, but must be "
       << smallest_density << " to " << largest_density << " kg/m3.";
  throw InputError(text.str());
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

dem::ClumpParameters clump_parameters(const Options& options)
{
  for (const auto& [name, value] :
       {std::pair("--d-min", options.d_min), {"--r-min", options.r_min}})
    if (value < 0)
      throw InputError(std::string("The option ") + name +
                       " is missing or negative, but must be a length of 0 m or more.");
  check_density(options);
  check_target("--target-volume-error", options.target_volume_error);
  check_target("--target-inertia-error", options.target_inertia_error);
  dem::ClumpParameters parameters = options.parameters;
  parameters.d_min = options.d_min;
  parameters.r_min = options.r_min;
  parameters.mass_scheme = dem::mass_scheme(options.scheme);
  parameters.touching_radius = dem::touching_radius(options.radius);
  parameters.target_volume_error = options.target_volume_error / 100;
  parameters.target_inertia_error = options.target_inertia_error / 100;
  dem::check_parameters(parameters);
  dem::length_of_unit(options.unit); // throws
  return parameters;
}

dem::StoneFileOptions file_options(const Options& options)
{
  dem::StoneFileOptions file;
  file.length_unit = dem::length_of_unit(options.unit);
  file.flip = options.flip;
  file.accept_crossings = options.accept_crossings;
  return file;
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

ClumpResult make_clump(const StoneFiles& files, const Options& options,
                       const dem::ClumpParameters& parameters)
{
  ClumpResult result;
  result.file = files.stone;
  result.name = files.name;
  result.density = options.density.value_or(0);
  result.parameters = parameters;
  std::error_code error;
  if (fs::is_regular_file(files.stone, error) && !is_named_as_stone(files.stone))
    throw InputError("The stone '" + files.stone +
                     "' is named neither as a mesh (.stl, .ply, .obj) nor as a cloud of points "
                     "(.xyz, .ply).");
  if (dem::is_point_cloud(files.stone))
    make_clump_of_cloud(options, result);
  else
    make_clump_of_mesh(options, result);
  result.shape.name = result.name;
  return result;
}

void make_one(const ClumpFiles& files, const Options& options,
              const dem::ClumpParameters& parameters)
{
  const StoneFiles& stone = files.stones.front();
  const ClumpResult result = make_clump(stone, options, parameters);
  const std::vector<dem::FileText> texts = clump_texts(stone, result);
  throw_if_interrupted();
  print_clump(result);
  std::printf("%s", missed_targets(result).c_str());
  write_files(texts);
  std::printf("Clump: '%s'\n", stone.clump.c_str());
  std::printf("%s", export_lines(stone, result).c_str());
  write_report(files.report, {result}, {});
  std::printf("Report: '%s'\n", files.report.c_str());
}

// Ends with one sentence a refused stone.
void throw_refusals(const std::vector<Refusal>& refusals, std::size_t stones)
{
  if (refusals.empty()) return;
  std::string text;
  for (const Refusal& refusal : refusals) text += refusal.sentence + "\n";
  throw InputError(text + std::to_string(refusals.size()) + " of " + std::to_string(stones) +
                   (refusals.size() == 1 ? " stones was refused." : " stones were refused."));
}

struct Clumps {
  std::vector<ClumpResult> results;
  std::vector<const StoneFiles*> files; // of the results
  std::vector<Refusal> refusals;
};

// Writes each clump as soon as it is there. A stone that is refused does not stop the others.
void make_clumps(const ClumpFiles& files, const Options& options,
                 const dem::ClumpParameters& parameters, Clumps& clumps)
{
  for (const StoneFiles& stone : files.stones) {
    throw_if_interrupted();
    std::vector<dem::FileText> texts;
    try {
      ClumpResult result = make_clump(stone, options, parameters);
      texts = clump_texts(stone, result);
      clumps.results.push_back(std::move(result));
    } catch (const InputError& error) {
      clumps.refusals.push_back({stone.stone, error.what()});
      continue;
    }
    throw_if_interrupted();
    write_files(texts);
    clumps.files.push_back(&stone);
    print_clump_table_row(clumps.results.back());
    std::fflush(stdout);
  }
}

void make_many(const ClumpFiles& files, const Options& options,
               const dem::ClumpParameters& parameters)
{
  print_clump_table_head();
  Clumps clumps;
  try {
    make_clumps(files, options, parameters, clumps);
  } catch (const Interrupted&) {
    std::printf("Interrupted: %zu of %zu clumps are in '%s'; there is no report.\n",
                clumps.files.size(), files.stones.size(), files.folder.c_str());
    throw;
  }
  if (clumps.results.empty()) throw_refusals(clumps.refusals, files.stones.size());
  print_clump_table_means(clumps.results);
  for (std::size_t i = 0; i < clumps.results.size(); ++i) {
    const ClumpResult& result = clumps.results[i];
    std::printf("%s%s%s", remarks(result).c_str(), missed_targets(result).c_str(),
                export_remarks(*clumps.files[i], result).c_str());
  }
  std::printf("%zu clumps in '%s'\n", clumps.results.size(), files.folder.c_str());
  write_report(files.report, clumps.results, clumps.refusals);
  std::printf("Report: '%s'\n", files.report.c_str());
  throw_refusals(clumps.refusals, files.stones.size());
}

void make(const Options& options)
{
  if (!options.table.empty()) return print_published_table(options.table);
  if (options.files.stones.empty())
    throw InputError("No stone is given: interlock clump STONE... (--help).");
  const dem::ClumpParameters parameters = clump_parameters(options);
  const ClumpFiles files = plan_clump_files(options.files);
  catch_interruption();
  if (files.stones.size() == 1)
    make_one(files, options, parameters);
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
  ClumpArguments& files = options->files;
  add("stones", files.stones,
      "Stones: closed meshes (.stl, .ply, .obj), clouds of points with normals (.ply, .xyz), or "
      "folders of them");
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
  add_seed_option(*command, p.seed, "Seed of the order of the nodes");
  add("--mass-properties", options->scheme, "Centre and inertia: uniform, equal-mass or mesh")
      ->capture_default_str();
  add("--density", options->density, "Density of the rock, for masses: 100 to 30000 [kg/m3]");
  add("--unit", options->unit, "Length unit of the stones: m, cm, mm or inch")
      ->capture_default_str();
  command->add_flag("--flip", options->flip, "The stones are inside out: turn them round");
  command->add_flag("--accept-crossings", options->accept_crossings,
                    "Take surfaces that cross themselves");
  add("-o,--output", files.output,
      "Clump file (default: the stone's name with .clump.json, here), or folder for it; folder for "
      "several stones");
  // One word an option, or it would take the stones behind it too.
  add("--format", files.formats,
      "Also write the clump for other codes, beside the clump file: lammps, liggghts, yade, "
      "mercury, pfc, csv, vtk; needs --density; all but csv and vtk get a name of letters, digits "
      "and _")
      ->delimiter(',')
      ->allow_extra_args(false);
  add("--report", files.report,
      "Report file (default: the clump file's name with .report.json; several stones: "
      "clumps.report.json in their folder)");
  add("--table", options->table,
      "Instead of all this: print a published table beside ours (octahedron)");
  command->callback([options] { make(*options); });
}
} // namespace interlock::apps
