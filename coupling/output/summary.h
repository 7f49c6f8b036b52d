// summary.json: what a finished run was and what came out.
#pragma once

#include "coupling/loop/energy_ledger.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace interlock::coupling
{
struct StageSummary {
  std::string name;
  std::int64_t steps = 0;
  double simulated_time = 0; // of this stage [s]
  double wall_time = 0;      // of this stage [s]
};

struct Summary {
  std::string version;           // of the program
  nlohmann::ordered_json origin; // commit, compiler, host, date: what no result depends on
  std::string parameters_hash;   // of used.prm, as `interlock report` compares it
  std::string experiment;
  int ranks = 1;
  std::uint64_t seed = 0; // of the filling
  std::int64_t clumps = 0;
  std::int64_t spheres = 0; // of all clumps together
  double time_step = 0;     // [s]
  std::int64_t steps = 0;
  double simulated_time = 0;     // [s]
  double wall_time = 0;          // [s]
  double wall_time_per_step = 0; // of the steps that were timed; 0: wall_time over steps [s]
  std::vector<StageSummary> stages;
  std::int64_t contacts = 0;         // touching sphere pairs at the end
  nlohmann::ordered_json energy;     // every ledger entry [J], and relative_error [-]
  nlohmann::ordered_json results;    // by experiment; names carry their unit: peak_force_N
  std::vector<std::string> warnings; // full sentences
  bool ledger_closes = true;         // false: a tenth of the work or more was made or lost
  std::string not_usable;            // why and from where on, a full sentence; empty: usable
  std::uint64_t state_hash = 0;      // of the whole state at the end (coupling/loop/state_hash.h)
};

// A hash as 16 digits: JSON numbers are doubles to many readers, which would lose some.
std::string hexadecimal(std::uint64_t hash);

// Writes every entry of the ledger [J], its residual, the work put in and the relative error [-]
// into summary.energy.
void add_ledger(Summary& summary, const EnergyLedger& ledger);

// Keys as listed in the members' order, with `_s` behind times, and
// state_hash as hexadecimal(). A number that is not finite becomes null.
nlohmann::ordered_json to_json(const Summary& summary);

// Writes `file` under a temporary name first. Throws std::runtime_error when the disk is full.
void write_summary(const std::filesystem::path& file, const Summary& summary);
} // namespace interlock::coupling
