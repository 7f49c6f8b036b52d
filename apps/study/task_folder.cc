#include "apps/study/task_folder.h"

#include "apps/build_info.h"
#include "apps/output_folder.h"
#include "apps/progress.h"
#include "coupling/files/atomic_file.h"
#include "coupling/run/checkpoints.h"

#include <boost/algorithm/string.hpp>

#include <fstream>
#include <sstream>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

std::optional<std::string> text_of(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// The first entry that differs between two complete parameter files.
std::string first_difference(const fs::path& there, const fs::path& wanted)
{
  const ScannedFile a = scan_parameter_file(there), b = scan_parameter_file(wanted);
  for (const Assignment& mine : b.assignments)
    for (const Assignment& other : a.assignments)
      if (mine.key() == other.key() && mine.value != other.value)
        return "\"" + mine.key() + "\" is \"" + other.value + "\" there and \"" + mine.value +
               "\" now";
  return "their lists of entries differ";
}
} // namespace

TaskFolder::TaskFolder(const Plan& plan, const Task& task)
    : study_(plan.folder), folder_(plan.folder / task.folder), name_(task.folder.string())
{
}

fs::path TaskFolder::case_file() const
{
  return study_ / "cases" / (name_ + ".prm");
}

fs::path TaskFolder::messages() const
{
  return study_ / "messages" / (name_ + ".txt");
}

TaskProgress TaskFolder::progress() const
{
  std::error_code error;
  if (!fs::exists(folder_ / "used.prm", error)) return TaskProgress::none;
  if (fs::exists(folder_ / "summary.json", error)) return TaskProgress::over;
  return coupling::has_checkpoint(folder_) ? TaskProgress::stopped : TaskProgress::none;
}

void TaskFolder::write_case(const std::string& used) const
{
  if (text_of(case_file()) == used) return;
  create_output_folder(case_file().parent_path());
  coupling::write_atomically(case_file(), used);
}

std::string TaskFolder::why_foreign(const std::string& used) const
{
  const std::optional<std::string> there = text_of(folder_ / "used.prm");
  if (!there) return {};
  const std::string start = "The run \"" + folder_.string() + "\" ";
  if (*there != used) {
    const fs::path wanted = folder_ / "wanted.prm";
    coupling::write_atomically(wanted, used);
    const std::string difference = first_difference(folder_ / "used.prm", wanted);
    fs::remove(wanted);
    return start + "was made with other entries (" + difference + ")";
  }
  const nlohmann::ordered_json made = summary();
  if (!made.is_object()) return {};
  const std::string commit = made["origin"].value("commit", "");
  if (made.value("version", "") == INTERLOCK_VERSION && commit == build_commit) return {};
  return start + "was made by another program (version " + made.value("version", "") + ", commit " +
         commit + "; this is " INTERLOCK_VERSION ", commit " + build_commit + ")";
}

void TaskFolder::forget() const
{
  std::error_code error;
  for (const char* file : {"summary.json", "checkpoint.h5", "checkpoint.previous.h5", "used.prm"})
    fs::remove(folder_ / file, error);
}

std::string TaskFolder::progress_of_log() const
{
  return last_progress(text_of(folder_ / "run.log").value_or(""));
}

nlohmann::ordered_json TaskFolder::summary() const
{
  std::ifstream in(folder_ / "summary.json");
  if (!in) return {};
  auto json = nlohmann::ordered_json::parse(in, nullptr, false);
  return json.is_object() ? json : nlohmann::ordered_json();
}

std::string TaskFolder::last_sentence() const
{
  std::vector<std::string> lines;
  boost::split(lines, text_of(messages()).value_or(""), boost::is_any_of("\n"));
  std::string last;
  for (const std::string& line : lines)
    if (boost::starts_with(line, "interlock: ")) last = line;
  for (const char* start : {"interlock: the run failed: ", "interlock: error: ", "interlock: "})
    if (boost::starts_with(last, start)) {
      last = last.substr(std::string(start).size());
      break;
    }
  boost::replace_all(last, study_.string() + "/", "");
  return last;
}
} // namespace interlock::apps
