// When and where a run keeps its state, and whether a kept state fits the case at hand.
#pragma once

#include "coupling/run/run_request.h"
#include "coupling/state/state_tree.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace interlock::coupling
{
class Checkpoints
{
public:
  // `interval` of wall-clock time between two of them [s]; 0: at the ends of stages only.
  // One that never `writes` reads only: it is never due, and all it should write or remove is left
  // to another rank.
  Checkpoints(std::filesystem::path folder, double interval, std::string program_version,
              bool writes = true);

  bool due() const;
  // Replaces checkpoint.h5; the one before is kept as checkpoint.previous.h5. Throws
  // std::runtime_error, one sentence, when the disk is full; both files are untouched then.
  void write(const StateTree& state);
  // The same under another name, and without keeping the one before.
  void write_as(const std::string& name, const StateTree& state) const;

  std::filesystem::path file() const { return folder_ / "checkpoint.h5"; }
  // The state to go on from. Throws InputError, one sentence, when there is none or the file is
  // damaged; the sentence names the one before when that one is good.
  StateTree read() const;
  // Removes those of an earlier run.
  void clear() const;

private:
  std::filesystem::path folder_;
  double interval_;
  std::string program_version_;
  bool writes_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Whether a run has left a checkpoint in this folder.
bool has_checkpoint(const std::filesystem::path& folder);

// Whether `key` is one of these, or lies in a section that is one of these ("Pull/").
bool is_among(const std::string& key, const std::vector<std::string>& keys_and_sections);

// Throws InputError, one sentence that names every entry of the case that differs from the one the
// state was made with although it must not. `what` begins the sentence: "The checkpoint
// results/quick/checkpoint.h5".
void require_same_case(const std::string& what, const std::vector<CaseEntry>& kept,
                       const std::vector<CaseEntry>& now,
                       const std::function<bool(const std::string& key)>& may_change);

// Keys of the entries that differ.
std::vector<std::string> changed_entries(const std::vector<CaseEntry>& kept,
                                         const std::vector<CaseEntry>& now);
} // namespace interlock::coupling
