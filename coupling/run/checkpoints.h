// When and where a run keeps its state, and whether a kept state fits the case at hand.
#pragma once

#include "coupling/state/state_tree.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace interlock::coupling
{
// An entry of a parameter file as text: "Geogrid/Youngs modulus", "2.4e9".
struct CaseEntry {
  std::string key, value;
};
template <class Archive> void exchange(Archive& archive, CaseEntry& entry)
{
  archive("key", entry.key);
  archive("value", entry.value);
}

class Checkpoints
{
public:
  // `interval` of wall-clock time between two of them [s]; 0: at the ends of stages only.
  Checkpoints(std::filesystem::path folder, double interval, std::string program_version);

  bool due() const;
  // Replaces checkpoint.h5; the one before is kept as checkpoint.previous.h5. Throws
  // std::runtime_error, one sentence, when the disk is full; both files are untouched then.
  void write(const StateTree& state);
  // The same under another name, and without keeping the one before.
  void write_as(const std::string& name, const StateTree& state) const;

  std::filesystem::path file() const { return folder_ / "checkpoint.h5"; }
  // The state to go on from; empty when this folder has none yet. Throws InputError, one sentence,
  // when the file is damaged; the sentence names the one before when that one is good.
  std::optional<StateTree> read() const;

private:
  std::filesystem::path folder_;
  double interval_;
  std::string program_version_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Throws InputError, one sentence that names every entry of the case that differs from the one the
// state was made with, but for those in `free` (keys, or whole sections as "Pull/"). `what` begins
// the sentence: "The checkpoint results/quick/checkpoint.h5".
void require_same_case(const std::string& what, const std::vector<CaseEntry>& kept,
                       const std::vector<CaseEntry>& now, const std::vector<std::string>& free);

// Keys of the entries that differ, those in `free` included.
std::vector<std::string> changed_entries(const std::vector<CaseEntry>& kept,
                                         const std::vector<CaseEntry>& now);
} // namespace interlock::coupling
