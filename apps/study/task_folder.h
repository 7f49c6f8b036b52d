// What stands on the disk of a run of a study: all that a later invocation goes by.
#pragma once

#include "apps/study/plan.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace interlock::apps
{
// How far a run is.
enum class TaskProgress {
  none,    // nothing that could be gone on with
  stopped, // it has a checkpoint
  over     // it has results
};

class TaskFolder
{
public:
  TaskFolder(const Plan& plan, const Task& task);

  std::filesystem::path folder() const { return folder_; }
  std::filesystem::path case_file() const; // a complete parameter file, to be run by hand, too
  std::filesystem::path messages() const;  // what the run has said on its error output

  TaskProgress progress() const;
  bool is_over() const { return progress() == TaskProgress::over; }

  // Writes case_file(), unless it is there.
  void write_case(const std::string& used) const;

  // Why what is there does not belong to this study, one sentence: a run with other entries, or of
  // another version of the program; empty when it does.
  std::string why_foreign(const std::string& used) const;
  // Removes the mark of a run that is over, so that it is made anew.
  void forget() const;

  // How far the run has come, as its log last said: "pull (5 of 6)  45 %"; empty where it did not.
  std::string progress_of_log() const;

  nlohmann::ordered_json summary() const; // null where there is none
  // The last sentence of a run that has failed or was refused, without names of this machine's
  // folders; empty when it said none.
  std::string last_sentence() const;

private:
  std::filesystem::path study_, folder_;
  std::string name_;
};
} // namespace interlock::apps
