#include "apps/case_run.h"

#include "apps/build_info.h"
#include "apps/case_hash.h"
#include "apps/closing_summary.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/ranks.h"
#include "apps/report_command.h"
#include "apps/run_folder.h"
#include "coupling/files/atomic_file.h"
#include "coupling/run/checkpoints.h"
#include "coupling/run/run_failure.h"
#include "dem/input_error.h"

#include <ctime>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

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
// Within a stage (which has a number) the run itself asks after every step, and keeps its state.
coupling::Monitor monitor_for(const CaseRun& run, ProgressDisplay& display)
{
  const bool alone = all_ranks().size() == 1;
  return {[&run, &display, alone](const coupling::Progress& progress) {
            if (alone && progress.number == 0) throw_if_interrupted();
            display.show(progress);
            if (run.watch && progress.world) run.watch(progress);
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
coupling::Summary simulate(const RunInput& input, const CaseRun& run,
                           const coupling::RunRequest& request, std::optional<RunFolder>& folder,
                           RunLog& log)
{
  const ReadyExperiment experiment = input.experiment->prepare(input.parameters, request);
  if (run.ready) run.ready(experiment);
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

coupling::RunRequest request_for(const CaseRun& run, const RunInput& input,
                                 ProgressDisplay& display)
{
  coupling::RunRequest request;
  request.folder = run.folder;
  request.entries = input.kept;
  request.version = INTERLOCK_VERSION;
  request.monitor = monitor_for(run, display);
  request.writes = all_ranks().rank() == 0;
  if (all_ranks().size() > 1) request.ranks = &all_ranks();
  // As the first rank sees the disk.
  const bool there = coupling::has_checkpoint(request.folder);
  request.resume = run.resume && all_ranks().largest(request.writes && there ? 1 : 0) > 0;
  if (run.resume && !request.resume)
    display.message("There is no checkpoint in " + request.folder.string() +
                    " yet: the run starts from the beginning.");
  return request;
}

// Tells what came out, draws it, says what to do next, and throws when it is not to be used.
void close(const RunInput& input, const coupling::Summary& summary, const fs::path& folder,
           bool quiet, ProgressDisplay& display)
{
  display.message(closing_summary(summary, folder));
  const bool draws = input.experiment->draws_figures(input.parameters);
  const bool drawn = !draws || draw_figures(folder, quiet) == 0;
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
} // namespace

coupling::Summary run_case(const RunInput& input, const CaseRun& run)
{
  RunLog log;
  const bool speaks = all_ranks().rank() == 0;
  std::ostream nowhere(nullptr);
  ProgressDisplay display(speaks && run.screen ? *run.screen : nowhere,
                          speaks && run.screen_is_terminal, log.stream());
  const coupling::RunRequest request = request_for(run, input, display);
  std::optional<RunFolder> owned;
  on_first_rank([&] {
    owned.emplace(request.folder, request.resume ? FolderUse::resume
                                  : run.force    ? FolderUse::replace
                                                 : FolderUse::fresh);
    if (!request.resume) check_start_state(input.entries, request.folder);
  });
  coupling::Summary summary;
  try {
    summary = simulate(input, run, request, owned, log);
  } catch (const coupling::RunStopped& stopped) {
    const std::string sentence = stopped.checkpoint().empty()
                                     ? "interrupted before there was a state to keep; start it anew"
                                     : "interrupted; the state is in " + stopped.checkpoint() +
                                           ", go on with: " + run.resume_line;
    log.stream() << "Stopped: " << sentence << std::endl;
    throw Interrupted(sentence);
  } catch (const std::exception& error) {
    log.stream() << "Stopped: " << error.what() << std::endl;
    throw;
  }
  on_first_rank([&] { close(input, summary, request.folder, run.screen == nullptr, display); });
  return summary;
}
} // namespace interlock::apps
