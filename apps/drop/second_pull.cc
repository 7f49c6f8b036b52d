#include "apps/drop/second_pull.h"

#include "apps/build_info.h"
#include "apps/interruption.h"
#include "apps/parameter_file.h"
#include "apps/progress.h"
#include "apps/run_folder.h"
#include "coupling/files/atomic_file.h"
#include "coupling/run/run_failure.h"
#include "dem/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

// Compares the rows of two histories while the second one grows.
class RowsOfBoth
{
public:
  RowsOfBoth(const fs::path& first, const fs::path& second, std::size_t rows)
      : first_(first), second_name_(second), lines_(rows + 1)
  {
  }

  bool all_equal() const { return compared_ == lines_; }

  // Throws std::runtime_error at a row that differs.
  void compare()
  {
    if (!second_.is_open()) second_.open(second_name_);
    std::string mine, other;
    while (compared_ < lines_ && std::getline(second_, mine)) {
      std::getline(first_, other);
      if (mine != other) throw std::runtime_error(difference(other, mine));
      ++compared_;
    }
    second_.clear(); // it goes on to grow
  }

private:
  std::string difference(const std::string& first, const std::string& second) const
  {
    if (compared_ == 0) return "the second pull has other columns than the first one.";
    return fmt::format("the second pull is not the first one: row {} of history.csv was \"{}\" and "
                       "is \"{}\" now; contacts at other forces are not drawn.",
                       compared_, first, second);
  }

  std::ifstream first_, second_;
  fs::path second_name_;
  std::size_t lines_, compared_ = 0; // the columns are the first line
};

std::string entry_of(const std::vector<coupling::CaseEntry>& entries, const std::string& key)
{
  for (const coupling::CaseEntry& entry : entries)
    if (entry.key == key) return entry.value;
  return {};
}

// The entries that may differ without a digit of the pull: docs/runs.md.
std::vector<std::string> overrides(const SecondPull& pull)
{
  return {"Start from=" + state_before_pull(pull.first).string(),
          fmt::format("Output/Frames at={}", fmt::join(pull.frames_at, ", ")),
          "Output/Field frames=0", "Output/Report=false", "Output/Checkpoint interval=0"};
}

// Nothing goes on from what has been drawn.
void remove_checkpoints(const fs::path& folder)
{
  std::error_code error;
  for (const char* file : {"checkpoint.h5", "checkpoint.previous.h5"})
    fs::remove(folder / file, error);
}
} // namespace

fs::path state_before_pull(const fs::path& folder)
{
  const fs::path own = folder / "state_before_pull.h5";
  if (fs::is_regular_file(own)) return own;
  const std::string start =
      entry_of(read_parameter_file(folder / "used.prm").entries, "Start from");
  const fs::path given = fs::path(start);
  if (!start.empty() && fs::is_regular_file(given)) return given;
  throw InputError(fmt::format(
      "The pull of \"{}\" cannot be made again: {}.", folder.string(),
      start.empty()
          ? "its state_before_pull.h5 is not there any more"
          : "neither its state_before_pull.h5 nor the state that it was started from, \"" + start +
                "\", is there any more"));
}

void pull_again(const SecondPull& pull)
{
  const RunInput input = read_parameter_file(pull.first / "used.prm", overrides(pull));
  const fs::path mark = pull.folder / second_pull_mark;
  if (fs::exists(pull.folder / "used.prm") && !fs::exists(mark))
    throw InputError(fmt::format("The folder \"{}\" is where the second pull would be, but holds a "
                                 "run that \"interlock drop\" has not made; give it another name.",
                                 pull.folder.string()));
  catch_interruption();
  RunFolder owned(pull.folder, FolderUse::replace);
  RowsOfBoth rows(pull.first / "history.csv", pull.folder / "history.csv", pull.rows);

  std::ofstream log;
  ProgressDisplay display(std::cout, isatty(STDOUT_FILENO) != 0, log);
  coupling::RunRequest request;
  request.folder = pull.folder;
  request.entries = input.kept;
  request.version = INTERLOCK_VERSION;
  request.monitor.message = [&](const std::string& sentence) { display.message(sentence); };
  request.monitor.progress = [&](const coupling::Progress& progress) {
    display.show(progress);
    rows.compare();
  };
  request.monitor.stop_requested = [&] { return is_interrupted() || rows.all_equal(); };

  const ReadyExperiment experiment = input.experiment->prepare(input.parameters, request);
  owned.take();
  coupling::write_atomically(mark, "Made by \"interlock drop\", and removed with the run above.\n");
  log.open(pull.folder / "run.log");
  coupling::write_atomically(pull.folder / "used.prm", input.used);
  try {
    experiment(request);
    rows.compare();
  } catch (const coupling::RunStopped&) {
    if (!rows.all_equal())
      throw Interrupted("interrupted; the same command starts the second pull again");
  }
  remove_checkpoints(pull.folder);
  if (!rows.all_equal())
    throw std::runtime_error("the second pull ended before it was where the force had dropped.");
}
} // namespace interlock::apps
