#include "apps/report_command.h"

#include "apps/case_hash.h"
#include "apps/experiments.h"
#include "apps/figure_script.h"
#include "apps/interruption.h"
#include "apps/parameter_scanner.h"
#include "apps/stone_surfaces.h"
#include "dem/input_error.h"

#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

// A study has a table of its runs; else by the experiment in used.prm, which a run writes first of
// all.
std::string script_for(const fs::path& folder)
{
  const std::string pull_out = "figures.py";
  if (fs::is_regular_file(folder / "runs.csv")) return "study_figures.py";
  const fs::path used = folder / "used.prm";
  if (!fs::is_regular_file(used)) return pull_out;
  for (const Assignment& assignment : scan_parameter_file(used).assignments) {
    if (assignment.key() != "Experiment") continue;
    const std::string experiment = present_name(assignment.value);
    if (experiment == "heap") return "heap_figures.py";
    if (experiment == "laboratory") return "laboratory_figures.py";
    if (experiment == "shear box") return "strength_figures.py";
    if (experiment == "triaxial") return "triaxial_figures.py";
  }
  return pull_out;
}

// report.html, with the surfaces of the stones where they can be made.
ScriptResult write_page(const fs::path& folder, bool quiet)
{
  std::error_code error;
  const fs::path surfaces = fs::temp_directory_path(error) /
                            ("interlock-" + std::to_string(getpid()) + "-stone_surfaces.json");
  const bool is_study = fs::is_regular_file(folder / "runs.csv", error);
  const std::string reason =
      is_study ? "A study has no stones." : write_stone_surfaces(folder, surfaces);
  std::vector<std::string> arguments = {folder.string()};
  if (reason.empty())
    arguments.insert(arguments.end(), {"--surfaces", surfaces.string()});
  else if (!is_study)
    arguments.insert(arguments.end(), {"--no-surfaces", reason});
  const ScriptResult result = run_figure_script("report.py", arguments, quiet);
  fs::remove(surfaces, error);
  return result;
}

struct Drawn {
  ScriptResult figures, page;
};

// Figures that broke keep no page from being written; a folder with nothing to draw and an
// interrupt do.
Drawn draw(const fs::path& folder, bool quiet)
{
  Drawn drawn;
  drawn.figures = run_figure_script(script_for(folder), {folder.string()}, quiet);
  if (drawn.figures.status == 2 || is_interrupted())
    drawn.page = drawn.figures;
  else
    drawn.page = write_page(folder, quiet);
  return drawn;
}
} // namespace

int draw_figures(const fs::path& folder, const bool quiet)
{
  const Drawn drawn = draw(folder, quiet);
  if (drawn.figures.status != 0)
    std::cerr << "interlock: the figures could not be drawn: " << drawn.figures.reason << '\n';
  else if (drawn.page.status != 0)
    std::cerr << "interlock: report.html could not be written: " << drawn.page.reason << '\n';
  return drawn.figures.status != 0 ? drawn.figures.status : drawn.page.status;
}

void add_report_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "report",
      "Draw the figures of a finished or running simulation into FOLDER/figures and write "
      "FOLDER/report.html, a page with everything in it.");
  auto folder = std::make_shared<std::string>();
  command
      ->add_option("folder", *folder, "Output folder of \"interlock run\" or \"interlock study\".")
      ->required();
  command->callback([folder] {
    if (!fs::is_directory(*folder))
      throw InputError("The folder \"" + *folder + "\" does not exist.");
    require_one_run(*folder);
    const Drawn drawn = draw(*folder, false);
    if (drawn.figures.status == 2) throw InputError(drawn.figures.reason);
    if (drawn.figures.status != 0)
      throw std::runtime_error("the figures could not be drawn: " + drawn.figures.reason);
    if (drawn.page.status != 0)
      throw std::runtime_error("report.html could not be written: " + drawn.page.reason);
  });
}
} // namespace interlock::apps
