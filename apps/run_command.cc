#include "apps/run_command.h"

#include "apps/build_info.h"
#include "apps/case_hash.h"
#include "apps/closing_summary.h"
#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/output_folder.h"
#include "apps/parameter_file.h"
#include "apps/progress.h"
#include "apps/ranks.h"
#include "apps/report_command.h"
#include "apps/run_folder.h"
#include "apps/shell_word.h"
#include "coupling/files/atomic_file.h"
#include "coupling/run/checkpoints.h"
#include "coupling/run/run_failure.h"
#include "coupling/output/summary.h"
#include "dem/input_error.h"

#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
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
  std::optional<std::string> output;
  bool resume = false, force = false, unusual = false;
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

// Several ranks stop when they have agreed to, not in the middle of what one of them does.
coupling::Monitor monitor_for(ProgressDisplay& display)
{
  const bool alone = all_ranks().size() == 1;
  return {[&display, alone](const coupling::Progress& progress) {
            if (alone) throw_if_interrupted();
            display.show(progress);
          },
          [&display](const std::string& sentence) { display.message(sentence); }, is_interrupted};
}

// Where and when a run ended, and with which program.
nlohmann::ordered_json origin()
{
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  const std::time_t now = std::time(nullptr);
  std::ostringstream date;
  date << std::put_time(std::gmtime(&now), "%Y-%m-%dT%H:%M:%SZ");
  return {{"commit", build_commit},
          {"commit_date", build_commit_date},
          {"compiler", build_compiler},
          {"host", host},
          {"date", date.str()}};
}

// Nothing is written before the experiment has accepted its parameters. `folder` is there on the
// rank that writes.
coupling::Summary simulate(const RunInput& input, const coupling::RunRequest& request,
                           std::optional<RunFolder>& folder, RunLog& log)
{
  const ReadyExperiment experiment = input.experiment->prepare(input.parameters, request);
  on_first_rank([&] {
    folder->take();
    log.open(request.folder / "run.log", request.resume);
    // A resumed run has the entries of its checkpoint, or is refused.
    if (!request.resume) coupling::write_atomically(request.folder / "used.prm", input.used);
  });

  coupling::Summary summary = experiment(request);
  on_first_rank([&] {
    summary.version = INTERLOCK_VERSION;
    summary.origin = origin();
    summary.parameters_hash = case_hash(request.folder / "used.prm");
    coupling::write_summary(request.folder / "summary.json", summary);
  });
  return summary;
}

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

// A run that starts from a state must not remove it.
void check_start_state(const std::vector<coupling::CaseEntry>& entries, const fs::path& folder)
{
  for (const coupling::CaseEntry& entry : entries) {
    if (entry.key != "Start from" || entry.value.empty()) continue;
    std::error_code error;
    if (fs::equivalent(fs::path(entry.value).parent_path(), folder, error))
      throw InputError("The state to start from lies in the output folder \"" + folder.string() +
                       "\", which this run would clear; choose another one with --output.");
  }
}

coupling::RunRequest request_for(const RunArguments& arguments, const RunInput& input,
                                 ProgressDisplay& display)
{
  coupling::RunRequest request;
  request.folder = output_folder(arguments);
  request.entries = input.entries;
  request.version = INTERLOCK_VERSION;
  request.monitor = monitor_for(display);
  request.writes = all_ranks().rank() == 0;
  if (all_ranks().size() > 1) request.ranks = &all_ranks();
  // As the first rank sees the disk.
  const bool there = coupling::has_checkpoint(request.folder);
  request.resume = arguments.resume && all_ranks().largest(request.writes && there ? 1 : 0) > 0;
  if (arguments.resume && !request.resume)
    display.message("There is no checkpoint in " + request.folder.string() +
                    " yet: the run starts from the beginning.");
  return request;
}

// Tells what came out, draws it, says what to do next, and throws when it is not to be used.
void close(const RunInput& input, const coupling::Summary& summary, const fs::path& folder,
           ProgressDisplay& display)
{
  display.message(closing_summary(summary, folder));
  const bool draws = input.experiment->draws_figures(input.parameters);
  const bool drawn = !draws || draw_figures(folder) == 0;
  if (!drawn && is_interrupted())
    throw Interrupted("interrupted while the figures were drawn; the run is whole, and \"interlock "
                      "report " +
                      folder.string() + "\" draws them");
  if (!drawn)
    display.message("warning: figures or report.html are missing; \"interlock report " +
                    folder.string() + "\" tries again.");
  else
    display.message(next_step(folder, draws));
  if (!summary.ledger_closes)
    throw std::runtime_error(
        "a tenth of the work or more was made or lost, see the warnings. What is in " +
        folder.string() + " is for finding out why.");
  if (!summary.not_usable.empty()) throw std::runtime_error(summary.not_usable);
}

void run(RunArguments arguments)
{
  if (arguments.unusual) arguments.overrides.push_back("Unusual values=true");
  const RunInput input = read_parameter_file(arguments.file, arguments.overrides);
  start_mpi();
  catch_interruption();

  RunLog log;
  const bool speaks = all_ranks().rank() == 0;
  std::ostream nowhere(nullptr);
  ProgressDisplay display(speaks ? std::cout : nowhere, speaks && isatty(STDOUT_FILENO) != 0,
                          log.stream());
  const coupling::RunRequest request = request_for(arguments, input, display);
  std::optional<RunFolder> owned;
  on_first_rank([&] {
    owned.emplace(request.folder, request.resume    ? FolderUse::resume
                                  : arguments.force ? FolderUse::replace
                                                    : FolderUse::fresh);
    if (!request.resume) check_start_state(input.entries, request.folder);
  });
  coupling::Summary summary;
  try {
    summary = simulate(input, request, owned, log);
  } catch (const coupling::RunStopped& stopped) {
    const std::string sentence = stopped.checkpoint().empty()
                                     ? "interrupted before there was a state to keep; start it anew"
                                     : "interrupted; the state is in " + stopped.checkpoint() +
                                           ", go on with: " + resume_line(arguments);
    log.stream() << "Stopped: " << sentence << std::endl;
    throw Interrupted(sentence);
  } catch (const std::exception& error) {
    log.stream() << "Stopped: " << error.what() << std::endl;
    throw;
  }
  on_first_rank([&] { close(input, summary, request.folder, display); });
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
