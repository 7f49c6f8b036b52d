#include "apps/stones_command.h"

#include "apps/clump_files.h"
#include "apps/interruption.h"
#include "apps/output_folder.h"
#include "apps/seed_option.h"
#include "dem/input_error.h"
#include "dem/scans/stone_names.h"
#include "dem/stones/stone_form.h"
#include "dem/stones/synthetic_stone.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

namespace interlock::apps
{
namespace
{
struct Options {
  int count = 0;
  std::uint64_t seed = 1;
  std::string folder;
  dem::StoneStyle style;
};

constexpr double density = 2650; // of granite, for the printed masses only [kg/m3]

void create_folder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw InputError("The folder '" + folder + "' for the stones cannot be created.");
}

std::string file_name(std::size_t stone)
{
  char name[32];
  std::snprintf(name, sizeof(name), "stone_%03zu.stl", stone + 1);
  return name;
}

// Stones of an earlier batch would be read with these ones.
void print_other_stones(const std::string& folder, std::size_t count)
{
  std::size_t others = 0;
  std::set<std::string> written;
  for (std::size_t i = 0; i < count; ++i) written.insert(file_name(i));
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    others += dem::is_stone_file(entry, dem::stone_endings) &&
              written.count(entry.path().filename().string()) == 0;
  if (others > 0)
    std::printf("Note: '%s' holds %zu other stone file%s too.\n", folder.c_str(), others,
                others == 1 ? "" : "s");
}

// Mean and standard deviation of what the stones have in common.
void print_summary(const std::vector<dem::StoneForm>& forms)
{
  const auto row = [&](const char* label, auto statistic) {
    const auto of = [&](auto member) {
      std::vector<double> values;
      for (const dem::StoneForm& form : forms) values.push_back(member(form));
      return statistic(values);
    };
    std::printf("%-14s %6s %7s %7s %8s %9.2f %10.2f %10.3f %9.3f %10.0f\n", label, "", "", "", "",
                of([](const auto& f) { return f.size.flatness(); }),
                of([](const auto& f) { return f.size.elongation(); }),
                of([](const auto& f) { return f.size.sphericity; }),
                of([](const auto& f) { return f.convexity; }),
                of([](const auto& f) { return f.angularity; }));
  };
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double x : values) sum += x;
    return sum / values.size();
  };
  row("mean", mean);
  if (forms.size() > 1)
    row("spread", [&](const std::vector<double>& values) {
      const double middle = mean(values);
      double squares = 0;
      for (const double x : values) squares += (x - middle) * (x - middle);
      return std::sqrt(squares / (values.size() - 1));
    });
}

void make(const Options& options)
{
  check_writable("The stone", std::filesystem::path(options.folder) / file_name(0));
  const auto stones = dem::make_stones(options.count, options.seed, options.style);
  catch_interruption(); // from here on there are files
  create_folder(options.folder);
  std::printf("%-14s %6s %7s %7s %8s %9s %10s %10s %9s %10s\n", "stone", "nodes", "sieve", "long",
              "mass", "flatness", "elongation", "sphericity", "convexity", "angularity");
  std::printf("%-14s %6s %7s %7s %8s %9s %10s %10s %9s %10s\n", "", "", "[mm]", "[mm]", "[g]",
              "S/I [-]", "I/L [-]", "[-]", "[-]", "AI [deg]");
  double mass = 0, long_mass = 0, widest_spacing = 0;
  std::vector<dem::StoneForm> forms;
  for (std::size_t i = 0; i < stones.size(); ++i) {
    throw_if_interrupted();
    const std::string name = file_name(i);
    dem::write_stl((std::filesystem::path(options.folder) / name).string(), stones[i]);
    const dem::StoneForm form = dem::stone_form(stones[i]);
    std::printf("%-14s %6zu %7.1f %7.1f %8.1f %9.2f %10.2f %10.3f %9.3f %10.0f\n", name.c_str(),
                stones[i].vertices.size(), 1e3 * form.size.sieve, 1e3 * form.size.longest,
                1e3 * density * form.volume, form.size.flatness(), form.size.elongation(),
                form.size.sphericity, form.convexity, form.angularity);
    mass += density * form.volume;
    if (form.size.longest > 3 * form.size.shortest) long_mass += density * form.volume;
    widest_spacing = std::max(widest_spacing, dem::node_spacing(stones[i]).variation);
    forms.push_back(form);
  }
  print_summary(forms);
  std::printf("%zu stones in '%s', %.2f kg at %.0f kg/m3, of which %.1f %% have L > 3 S. L, I, S:\n"
              "longest, intermediate, shortest axis. Lengths of edges vary by %.0f %% (standard "
              "deviation) on the\nleast even mesh. Definitions and published values: "
              "docs/theory/stones.md.\n",
              stones.size(), options.folder.c_str(), mass, density, 100 * long_mass / mass,
              100 * widest_spacing);
  print_other_stones(options.folder, stones.size());
}

void add_style_options(CLI::App& command, dem::StoneStyle& style)
{
  const auto add = [&](const char* name, auto& entry, const char* text) {
    command.add_option(name, entry, text)->capture_default_str()->group("Form of the stones");
  };
  add("--spacing", style.spacing,
      "Distance of nodes [m]; 0.0005: some 20,000 a stone; 0: 1692 to 2562");
  add("--flatness", style.flatness, "Mean of shortest over intermediate axis [-]");
  add("--flatness-spread", style.flatness_spread, "Its standard deviation [-]");
  add("--elongation", style.elongation, "Mean of intermediate over longest axis [-]");
  add("--elongation-spread", style.elongation_spread, "Its standard deviation [-]");
  add("--faces", style.faces, "Mean number of fracture faces; fewer are more angular");
  add("--edge-wear", style.edge_wear,
      "Rounding of edges over distance from the centre [-]; less: angular");
  add("--scars", style.scars, "Mean number of hollow (conchoidal) faces");
  add("--scar-depth", style.scar_depth,
      "Depth of a hollow half a stone across, over the sieve size [-]");
  add("--steps", style.steps, "Mean number of steps left by broken-off flakes");
  add("--roughness", style.roughness, "Rms height of the waves of 10 mm [m]");
  add("--roughness-exponent", style.roughness_exponent,
      "Height of waves grows with this power of their length [-]");
}
} // namespace

void add_stones_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "stones", "Write synthetic angular ballast stones with the sizes of railway ballast");
  command->add_option("--count", options->count, "Number of stones")->required();
  add_seed_option(*command, options->seed, "Seed of the forms");
  command->add_option("-o,--output", options->folder, "Folder for stone_001.stl ...")->required();
  add_style_options(*command, options->style);
  command->callback([options] { make(*options); });
}
} // namespace interlock::apps
