// The packing experiment: a packed state from a file, run and timed. It shows what a step costs,
// and checks forces, lists and energies of a known packing on the way.
//
// Frame: the box of the file, x and y along its sides from 0, z up from its floor; open at the top.
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/output/history.h"
#include "coupling/output/monitor.h"
#include "coupling/output/summary.h"
#include "coupling/packing/packed_state.h"
#include "coupling/packing/packing_parameters.h"
#include "dem/engine/engine.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

namespace interlock::coupling
{
class Packing
{
public:
  // Reads and prepares the state (small spheres, squeeze). Writes nothing. Throws InputError, one
  // full sentence, when the state or the time step cannot be used.
  Packing(const PackingParameters& parameters, const Monitor& monitor);

  // Warms up, then runs the timed steps, and writes history.csv and summary.json into `output`,
  // which must exist, and the state before the first step where the parameters say so. The time of
  // a step is that of the engine's whole step, without records and checks. Throws
  // std::runtime_error when the simulation fails, a missed contact included, and lets pass what the
  // monitor throws.
  Summary run(const std::filesystem::path& output);

private:
  using Clock = std::chrono::steady_clock;
  // Sums over the steps of the stage, but for those with records and checks.
  struct Loads {
    double floor = 0, side_walls = 0; // vertical forces of the stones on the walls, downwards [N]
    std::int64_t steps = 0;
  };

  void build();
  void throw_stones();
  void begin_stage(const std::string& name);
  void end_stage(const std::string& result);
  void warn(const std::string& sentence);
  void step();
  void step_with(const std::function<void()>& look);
  void run_steps(int n, double& wall_time);
  void warm_up();
  void run_timed(const std::filesystem::path& output);
  void book();
  void record(History& history);
  void check_for_missed_contacts();
  void add_profile();
  void collect_results();
  void collect_speed();
  void collect_energies();

  PackingParameters parameters_;
  Monitor monitor_;
  PackedState state_; // before the first step
  std::unique_ptr<dem::Engine> engine_;
  double dt_ = 0;       // [s]
  double weight_ = 0;   // of all stones [N]
  double inserted_ = 0; // energy of contacts and throws that no clump brought in when added [J]

  double time_ = 0; // [s]
  std::int64_t steps_ = 0;
  double fraction_ = 0; // of the stage
  Summary summary_;
  Clock::time_point run_start_, stage_start_;
  std::int64_t stage_steps_ = 0;
  double timed_ = 0; // wall time of the timed steps [s]
  Loads loads_;
  dem::StepProfile profile_;
  EnergyLedger ledger_;
};
} // namespace interlock::coupling
