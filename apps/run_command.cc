#include "apps/run_command.h"

#include "apps/interruption.h"
#include "apps/output_folder.h"
#include "apps/parameter_file.h"
#include "apps/progress.h"
#include "apps/report_command.h"
#include "coupling/files/atomic_file.h"
#include "coupling/run/checkpoints.h"
#include "coupling/run/run_failure.h"
#include "coupling/output/summary.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
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
  bool resume = false;
};

// run.log: kept in memory until the input is known to be good and the folder exists.
class RunLog
{
public:
  std::ostream& stream() { return stream_; }

  void open(const fs::path& file, bool go_on)
  {
    file_.open(file, go_on ? std::ios::app : std::ios::trunc);
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
          [&display](const std::string& sentence) { display.message(sentence); }, is_interrupted};
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
coupling::Summary simulate(const RunInput& input, coupling::RunRequest request, RunLog& log)
{
  const ReadyExperiment experiment = input.experiment->prepare(input.parameters, request);
  create_output_folder(request.folder);
  log.open(request.folder / "run.log", request.resume);
  // A resumed run has the entries of its checkpoint, or is refused.
  if (!request.resume) coupling::write_atomically(request.folder / "used.prm", input.used);

  coupling::Summary summary = experiment(request);
  summary.version = INTERLOCK_VERSION;
  coupling::write_summary(request.folder / "summary.json", summary);
  return summary;
}

// As a shell takes it for one word.
std::string quoted(const std::string& word)
{
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("_./=+-:,@%").find(c) != std::string::npos;
  });
  if (plain && !word.empty()) return word;
  return "'" + boost::algorithm::replace_all_copy(word, "'", "'\\''") + "'";
}

// What to type to go on with the same run.
std::string resume_line(const RunArguments& arguments)
{
  std::string line = "interlock run " + quoted(arguments.file);
  for (const std::string& entry : arguments.overrides) line += " --set " + quoted(entry);
  if (!arguments.output.empty()) line += " --output " + quoted(arguments.output);
  return line + " --resume";
}

coupling::RunRequest request_for(const RunArguments& arguments, const RunInput& input,
                                 ProgressDisplay& display)
{
  coupling::RunRequest request;
  request.folder =
      arguments.output.empty() ? default_output_folder(arguments.file) : fs::path(arguments.output);
  check_output_folder(request.folder);
  request.entries = input.entries;
  request.version = INTERLOCK_VERSION;
  request.monitor = monitor_for(display);
  request.resume = arguments.resume && coupling::has_checkpoint(request.folder);
  if (arguments.resume && !request.resume)
    display.message("There is no checkpoint in " + request.folder.string() +
                    " yet: the run starts from the beginning.");
  return request;
}

void run(const RunArguments& arguments)
{
  const RunInput input = read_parameter_file(arguments.file, arguments.overrides);
  catch_interruption();

  RunLog log;
  ProgressDisplay display(std::cout, isatty(STDOUT_FILENO) != 0, log.stream());
  const coupling::RunRequest request = request_for(arguments, input, display);
  const fs::path& folder = request.folder;
  coupling::Summary summary;
  try {
    summary = simulate(input, request, log);
  } catch (const coupling::RunStopped& stopped) {
    const std::string sentence = "interrupted; the state is in " + stopped.checkpoint() +
                                 ", go on with: " + resume_line(arguments);
    log.stream() << "Stopped: " << sentence << std::endl;
    throw Interrupted(sentence);
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
  command->add_flag(
      "--resume", arguments->resume,
      "Go on from the checkpoint in the output folder; from the beginning when there is "
      "none yet.");
  command->footer("Example: interlock run cases/pullout/quick.prm --set \"Geogrid/Rigid=true\" -o "
                  "results/rigid");
  command->callback([arguments] { run(*arguments); });
}
} // namespace interlock::apps
