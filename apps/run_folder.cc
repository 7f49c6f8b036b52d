#include "apps/run_folder.h"

#include "apps/output_folder.h"
#include "coupling/run/checkpoints.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cerrno>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

bool is_there(const fs::path& file)
{
  std::error_code error;
  return fs::exists(file, error);
}

void refuse_results(const fs::path& folder)
{
  const std::string start = "The output folder \"" + folder.string() + "\" holds a ";
  const std::string end =
      "--force removes it to make space for this one, --output NAME writes elsewhere.";
  if (is_there(folder / "summary.json")) throw InputError(start + "finished run; " + end);
  if (coupling::has_checkpoint(folder))
    throw InputError(start + "run that was stopped; --resume goes on with it, " + end);
}

// What runs of any experiment write at the top of their folder.
bool is_of_a_run(const fs::path& file)
{
  const std::string name = file.filename().string(), ending = file.extension().string();
  for (const char* known : {"used.prm", "summary.json", "history.csv", "table.csv", "stones.csv",
                            "profile.csv", "report.html", "drop.json"})
    if (name == known) return true;
  const bool series = ending == ".xdmf" || ending == ".pvd";
  const bool index = ending == ".h5" && is_there(fs::path(file).replace_extension(".xdmf"));
  const bool state = ending == ".h5" &&
                     (boost::starts_with(name, "state_") || boost::starts_with(name, "checkpoint"));
  return series || index || state;
}

void remove_results(const fs::path& folder)
{
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && is_of_a_run(entry.path())) files.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(folder / "frames", error))
    for (const char* ending : {".vtkhdf", ".h5"}) // the second one: of an older version
      if (entry.path().extension() == ending) files.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(folder / "figures", error))
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  // Results first and parameters last: whatever interrupts this leaves no results without theirs.
  std::stable_partition(files.begin(), files.end(),
                        [](const fs::path& file) { return file.filename() != "used.prm"; });
  for (const fs::path& file : files) fs::remove(file, error);
  fs::remove(folder / "frames", error); // when they are empty
  fs::remove(folder / "figures", error);
  const fs::path second_pull = folder / "drop";
  if (!is_there(second_pull / second_pull_mark)) return;
  remove_results(second_pull);
  fs::remove(second_pull / "run.log", error);
  fs::remove(second_pull / second_pull_mark, error);
  fs::remove(second_pull, error);
}
} // namespace

RunFolder::RunFolder(fs::path folder, FolderUse use) : folder_(std::move(folder)), use_(use)
{
  if (folder_.empty())
    throw InputError("The option --output is empty, but must be the name of a folder.");
  check_output_folder(folder_);
  lock(false);
  if (use_ == FolderUse::fresh) refuse_results(folder_);
}

void RunFolder::Descriptor::close()
{
  if (number >= 0) ::close(number); // which unlocks it
  number = -1;
}

void RunFolder::take()
{
  create_output_folder(folder_);
  lock(true);
  if (use_ != FolderUse::resume) remove_results(folder_);
}

// The system lets go of the lock when a process ends, however it ends. File systems that know no
// locks leave the folder without an owner.
void RunFolder::lock(bool make)
{
  if (lock_.number >= 0) return;
  const std::string log = (folder_ / "run.log").string();
  lock_.number = open(log.c_str(), O_RDWR | O_CLOEXEC | (make ? O_CREAT : 0), 0666);
  if (lock_.number < 0) return; // not there yet; who cannot write it is told so by who has to
  if (flock(lock_.number, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  lock_.close();
  throw InputError("The output folder \"" + folder_.string() +
                   "\" is in use: another run is writing there; choose another one with --output.");
}
} // namespace interlock::apps
