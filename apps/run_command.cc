#include "apps/run_command.h"

#include "apps/interruption.h"
#include "apps/output_folder.h"
#include "apps/parameter_file.h"
#include "apps/progress.h"
#include "apps/report_command.h"
#include "coupling/files/atomic_file.h"
#include "coupling/output/summary.h"

#include <fstream>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

struct RunArguments {
  std::string file;
  std::vector<std::string> overrides;
  std::string output;
};

// run.log: kept in memory until the input is known to be good and the folder exists.
class RunLog
{
public:
  std::ostream& stream() { return stream_; }

  void open(const fs::path& file)
  {
    file_.open(file);
    file_ << early_.str();
    stream_.rdbuf(file_.rdbuf());
  }

private:
  std::ostringstream early_;
  std::ofstream file_;
  std::ostream stream_{early_.rdbuf()};
};

coupling::Monitor monitor_for(ProgressDisplay& display)
{
  return {[&display](const coupling::Progress& progress) {
            throw_if_interrupted();
            display.show(progress);
          },
          [&display](const std::string& sentence) { display.message(sentence); }};
}

std::string closing_text(const coupling::Summary& summary, const fs::path& folder)
{
  std::ostringstream text;
  text << "Done: ";
  if (summary.clumps > 0)
    text << summary.clumps << " stones of " << summary.spheres << " spheres, ";
  text << summary.steps << " steps in " << duration_text(summary.wall_time) << '.';
  for (const auto& result : summary.results.items())
    text << "\n  " << result.key() << " = " << result.value();
  if (summary.energy.contains("relative_error"))
    text << "\n  relative error of the energy ledger = " << summary.energy["relative_error"];
  text << "\nEverything is in " << folder.string() << '.';
  return text.str();
}

// Nothing is written before the experiment has accepted its parameters.
coupling::Summary simulate(const RunInput& input, const fs::path& folder, RunLog& log,
                           const coupling::Monitor& monitor)
{
  const ReadyExperiment experiment = input.experiment->prepare(input.parameters, monitor);
  create_output_folder(folder);
  log.open(folder / "run.log");
  coupling::write_atomically(folder / "used.prm", input.used);

  coupling::Summary summary = experiment(folder);
  summary.version = INTERLOCK_VERSION;
  coupling::write_summary(folder / "summary.json", summary);
  return summary;
}

void run(const RunArguments& arguments)
{
  const RunInput input = read_parameter_file(arguments.file, arguments.overrides);
  const fs::path folder =
      arguments.output.empty() ? default_output_folder(arguments.file) : fs::path(arguments.output);
  check_output_folder(folder);
  catch_interruption();

  RunLog log;
  ProgressDisplay display(std::cout, isatty(STDOUT_FILENO) != 0, log.stream());
  coupling::Summary summary;
  try {
    summary = simulate(input, folder, log, monitor_for(display));
  } catch (const std::exception& error) {
    log.stream() << "Stopped: " << error.what() << std::endl;
    throw;
  }
  display.message(closing_text(summary, folder));
  if (input.experiment->draws_figures(input.parameters) && draw_figures(folder) != 0)
    display.message("warning: the figures could not be drawn; \"interlock report " +
                    folder.string() + "\" tries again.");
  if (!summary.ledger_closes)
    throw std::runtime_error(
        "a tenth of the work or more was made or lost, see the warnings. What is in " +
        folder.string() + " is for finding out why.");
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
          "Override an entry of the file: \"Geogrid/Youngs modulus=2e9\"; may be repeated.")
      ->take_all()
      ->expected(1);
  command->add_option("-o,--output", arguments->output,
                      "Output folder; results/NAME for a file NAME.prm if not given.");
  command->footer("Example: interlock run cases/pullout/quick.prm --set \"Geogrid/Rigid=true\" -o "
                  "results/rigid");
  command->callback([arguments] { run(*arguments); });
}
} // namespace interlock::apps
