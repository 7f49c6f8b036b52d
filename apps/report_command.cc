#include "apps/report_command.h"

#include "apps/case_hash.h"
#include "apps/experiments.h"
#include "apps/figure_script.h"
#include "apps/parameter_scanner.h"
#include "dem/input_error.h"

#include <iostream>
#include <stdexcept>

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

ScriptResult draw(const fs::path& folder)
{
  return run_figure_script(script_for(folder), folder.string());
}
} // namespace

int draw_figures(const fs::path& folder)
{
  const ScriptResult result = draw(folder);
  if (result.status != 0)
    std::cerr << "interlock: the figures could not be drawn: " << result.reason << '\n';
  return result.status;
}

void add_report_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "report", "Draw the figures of a finished or running simulation into FOLDER/figures.");
  auto folder = std::make_shared<std::string>();
  command
      ->add_option("folder", *folder, "Output folder of \"interlock run\" or \"interlock study\".")
      ->required();
  command->callback([folder] {
    if (!fs::is_directory(*folder))
      throw InputError("The folder \"" + *folder + "\" does not exist.");
    require_one_run(*folder);
    const ScriptResult result = draw(*folder);
    if (result.status == 2) throw InputError(result.reason);
    if (result.status != 0)
      throw std::runtime_error("the figures could not be drawn: " + result.reason);
  });
}
} // namespace interlock::apps
