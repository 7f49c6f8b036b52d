#include "apps/stones_command.h"

#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/stone_size.h"
#include "dem/synthetic_stone.h"

#include <cstdio>
#include <filesystem>
#include <memory>

namespace interlock::apps
{
namespace
{
struct Options {
  int count = 0;
  std::uint64_t seed = 1;
  std::string folder;
};

constexpr double density = 2650; // of granite, for the printed masses only [kg/m3]

void create_folder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw InputError("The folder '" + folder + "' for the stones cannot be created.");
}

void make(const Options& options)
{
  const auto stones = dem::make_stones(options.count, options.seed);
  create_folder(options.folder);
  std::printf("%-14s %6s %10s %10s %9s %11s %11s\n", "stone", "nodes", "sieve [mm]", "long [mm]",
              "mass [g]", "flatness", "elongation");
  double total = 0;
  for (std::size_t i = 0; i < stones.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof(name), "stone_%03zu.stl", i + 1);
    dem::write_stl((std::filesystem::path(options.folder) / name).string(), stones[i]);
    const dem::StoneSize size = dem::stone_size(stones[i]);
    const double mass = density * dem::mass_properties(stones[i]).volume;
    total += mass;
    std::printf("%-14s %6zu %10.1f %10.1f %9.1f %11.2f %11.2f\n", name, stones[i].vertices.size(),
                1e3 * size.sieve, 1e3 * size.longest, 1e3 * mass, size.flatness(),
                size.elongation());
  }
  std::printf("%zu stones in '%s', %.2f kg at %.0f kg/m3; flatness is shortest/intermediate, "
              "elongation intermediate/longest axis.\n",
              stones.size(), options.folder.c_str(), total, density);
}
} // namespace

void add_stones_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "stones", "Write synthetic angular ballast stones with the sizes of railway ballast");
  command->add_option("--count", options->count, "Number of stones")->required();
  command->add_option("--seed", options->seed, "Seed of the forms")->capture_default_str();
  command->add_option("-o,--output", options->folder, "Folder for stone_001.stl ...")->required();
  command->callback([options] { make(*options); });
}
} // namespace interlock::apps
