// What a run is asked to do, beside the parameters of its experiment.
#pragma once

#include "coupling/output/monitor.h"
#include "dem/parallel/ranks.h"

#include <filesystem>
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

struct RunRequest {
  std::filesystem::path folder;    // of the output; exists when the run begins
  std::vector<CaseEntry> entries;  // of the case, as used
  bool resume = false;             // go on from the checkpoint in the folder
  double checkpoint_interval = 60; // of wall-clock time; 0: at the ends of stages only [s]
  std::string version;             // of the program
  // What the stages will take, in the plan's order, in any unit (Forecast::time); empty: not known.
  // A resumed run has those of its beginning.
  std::vector<double> stage_times;
  Monitor monitor;
  // That share the stones; null: one. They outlive the run.
  const dem::Ranks* ranks = nullptr;
  bool writes = true; // the files; one of the ranks does
};
} // namespace interlock::coupling
