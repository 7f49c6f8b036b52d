#include "apps/run_command.h"

#include "apps/case_run.h"
#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/output_folder.h"
#include "apps/shell_word.h"

#include <iostream>
#include <memory>
#include <optional>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

struct RunArguments {
  std::string file;
  std::vector<std::string> overrides;
  std::optional<std::string> output;
  bool resume = false, force = false, unusual = false;
};

// What to type to go on with the same run.
std::string resume_line(const RunArguments& arguments)
{
  std::string line = "interlock run " + shell_word(arguments.file);
  for (const std::string& entry : arguments.overrides) line += " --set " + shell_word(entry);
  if (arguments.output) line += " --output " + shell_word(*arguments.output);
  return line + " --resume";
}

fs::path output_folder(const RunArguments& arguments)
{
  return arguments.output ? fs::path(*arguments.output) : default_output_folder(arguments.file);
}

void run(RunArguments arguments)
{
  if (arguments.unusual) arguments.overrides.push_back("Unusual values=true");
  const RunInput input = read_parameter_file(arguments.file, arguments.overrides);
  start_mpi();
  catch_interruption();

  CaseRun run;
  run.folder = output_folder(arguments);
  run.resume = arguments.resume;
  run.force = arguments.force;
  run.resume_line = resume_line(arguments);
  run.screen = &std::cout;
  run.screen_is_terminal = isatty(STDOUT_FILENO) != 0;
  run_case(input, run);
}
} // namespace

void add_run_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand("run", "Simulate what a parameter file describes.");
  auto arguments = std::make_shared<RunArguments>();
  command->add_option("file", arguments->file, "Parameter file (.prm); see \"interlock template\".")
      ->required();
  command
      ->add_option(
          "--set", arguments->overrides,
          "Override an entry of the file: \"Contact/Stone friction=0.5\"; may be repeated.")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  command->add_option("-o,--output", arguments->output,
                      "Output folder; results/NAME for a file NAME.prm if not given.");
  command->add_flag(
      "--resume", arguments->resume,
      "Go on from the checkpoint in the output folder; from the beginning when there is "
      "none yet.");
  command->add_flag("--force", arguments->force,
                    "Remove the results of an earlier run in the output folder first.");
  command->add_flag("--unusual", arguments->unusual,
                    "Take values that are far from those of ballast and geogrids as they are.");
  command->footer(
      "Example: interlock run cases/pullout/quick.prm --set \"Start "
      "from=results/quick/state_before_pull.h5\" --set \"Contact/Geogrid friction=0.4\" -o "
      "results/smoother\n\nExit codes: 0 done, 2 the input is refused, 3 the run failed or its "
      "result is not to be used, 130 interrupted.");
  command->callback([arguments] { run(*arguments); });
}
} // namespace interlock::apps
