#include "apps/clump_command.h"

#include "dem/clump_generator.h"
#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/stone_size.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace interlock::apps
{
namespace
{
struct Options {
  std::string stone, scheme = "mesh", unit = "m", output;
  dem::ClumpParameters parameters;
};

double metres(const std::string& unit)
{
  if (unit == "m") return 1;
  if (unit == "mm") return 1e-3;
  throw InputError("The length unit of the stone is '" + unit + "', but must be 'm' or 'mm'.");
}

void print_stone(const std::string& path, const dem::TriangleMesh& stone)
{
  const dem::StoneSize size = dem::stone_size(stone);
  std::printf("Stone '%s': %zu nodes, %zu facets, closed\n", path.c_str(), stone.vertices.size(),
              stone.triangles.size());
  std::printf("  size %.2f x %.2f x %.2f mm, sieve size %.2f mm, volume %.4g cm3\n",
              1e3 * size.longest, 1e3 * size.intermediate, 1e3 * size.shortest, 1e3 * size.sieve,
              1e6 * dem::mass_properties(stone).volume);
  std::printf("  flatness %.3f, elongation %.3f, sphericity %.3f\n", size.flatness(),
              size.elongation(), size.sphericity);
}

void print_clump(const dem::ClumpShape& shape, const dem::ClumpReport& report,
                 const std::string& scheme)
{
  std::printf("Clump: %zu spheres, radius %.3f to %.3f mm\n", shape.spheres.size(),
              1e3 * shape.spheres.back().radius, 1e3 * shape.spheres.front().radius);
  std::printf("  nodes used %d of %d (%.2f %%), rejected below r_min %d\n", report.nodes_used,
              report.nodes, 100. * report.nodes_used / report.nodes, report.rejected);
  std::printf("  distance of the stone's surface: mean %.3f mm, 95 %% below %.3f mm, max %.3f mm\n",
              1e3 * report.surface_distance_mean, 1e3 * report.surface_distance_95,
              1e3 * report.surface_distance_max);
  std::printf("  volume of the spheres' union against the stone: %+.2f %%\n",
              100 * report.volume_error);
  std::printf("  %-16s %22s %20s\n", "mass properties", "error of moments [%]",
              "centre off by [mm]");
  const char* names[] = {"uniform", "equal-mass", "mesh"};
  for (int k = 0; k < 3; ++k)
    std::printf("%s %-16s %22.2f %20.3f\n", scheme == names[k] ? " *" : "  ", names[k],
                100 * report.inertia_error[k], 1e3 * report.centre_offset[k]);
  std::printf("  * used; the mass is that of the stone under each of them\n");
}

void make(const Options& options)
{
  namespace fs = std::filesystem;
  dem::ClumpParameters parameters = options.parameters;
  parameters.mass_scheme = dem::mass_scheme(options.scheme);
  const dem::TriangleMesh stone = dem::read_stone_mesh(options.stone, metres(options.unit));
  dem::ClumpReport report;
  dem::ClumpShape shape = dem::make_clump(stone, parameters, &report);
  shape.name = fs::path(options.stone).stem().string();
  print_stone(options.stone, stone);
  print_clump(shape, report, options.scheme);

  const std::string output = options.output.empty() ? shape.name + ".clump.json" : options.output;
  std::error_code error; // write_clump_shape says so when the folder is not there
  if (fs::path(output).has_parent_path())
    fs::create_directories(fs::path(output).parent_path(), error);
  dem::write_clump_shape(output, shape);
  std::printf("Written: '%s'\n", output.c_str());
}
} // namespace

void add_clump_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("clump", "Turn a closed stone mesh into a clump of spheres");
  dem::ClumpParameters& p = options->parameters;
  command->add_option("stone", options->stone, "Closed mesh: .stl, .ply or .obj")->required();
  command->add_option("--d-min", p.d_min, "Nodes nearer to a sphere's surface get no sphere [m]")
      ->required();
  command->add_option("--r-min", p.r_min, "Smaller spheres are rejected [m]")->required();
  command->add_option("--p-max", p.p_max, "Largest share of the nodes to be used [%]")->required();
  command->add_option("--seed", p.seed, "Seed of the order of the nodes")->capture_default_str();
  command
      ->add_option("--mass-properties", options->scheme,
                   "Centre and inertia: uniform, equal-mass or mesh")
      ->capture_default_str();
  command->add_option("--unit", options->unit, "Length unit of the mesh: m or mm")
      ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "Clump file (default: the stone's name with .clump.json, here)");
  command->callback([options] { make(*options); });
}
} // namespace interlock::apps
