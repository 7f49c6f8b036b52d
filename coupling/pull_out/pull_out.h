// The pull-out experiment: fill the lower half of the box, place the geogrid, fill the upper half,
// load it, let it settle, pull (Ferellec and McDowell 2010, section 4).
//
// Frame: x along the pull, the front wall with its slot at x = 0 and the pull towards -x; y across;
// z up from the floor of the box.
#pragma once

#include "coupling/loop/staggered_step.h"
#include "coupling/output/field_frames.h"
#include "coupling/output/history.h"
#include "coupling/output/monitor.h"
#include "coupling/output/summary.h"
#include "coupling/pull_out/pull_out_parameters.h"
#include "coupling/stones/filling.h"

#include <chrono>
#include <filesystem>
#include <memory>

namespace interlock::coupling
{
class PullOut
{
public:
  // Makes the clumps and checks what only they can tell (the stable step). Writes nothing. Throws
  // InputError, one full sentence, when a stone or the time step cannot be used.
  PullOut(const PullOutParameters& parameters, const Monitor& monitor);

  // Runs all stages and writes history, fields and summary.json into `output`, which must exist.
  // Throws std::runtime_error when the simulation fails, and lets pass what the monitor throws.
  Summary run(const std::filesystem::path& output);

  double time_step() const { return dt_; } // [s]

private:
  using Clock = std::chrono::steady_clock;

  void begin_stage(const std::string& name);
  void end_stage(const std::string& result);
  void step(double fraction, EnergyLedger* ledger = nullptr);
  void warn(const std::string& sentence);

  void fill_to(double height, double margin, const std::string& stage);
  enum class Settling { between_pours, before_pull };
  void settle(double at_least, double fraction_begin, Settling settling);
  double settled_energy(Settling settling) const;
  void settle_before_pull();
  void describe_packing();
  void drop_lost_stones();
  void warn_of_rib_at_wall();
  void watch_pull();
  void press_surface(double height);
  void place_geogrid();
  void clear_ribs();
  void add_surcharge();
  void add_plate();
  void pull(const std::filesystem::path& output);
  void record(History& history, double displacement);
  void collect_results();

  PullOutParameters parameters_;
  Monitor monitor_;
  dem::ContactProperties stone_on_stone_, stone_on_box_, stone_on_rib_;
  std::unique_ptr<dem::Engine> engine_;
  std::unique_ptr<Filling> filling_;
  std::unique_ptr<StaggeredStep> loop_;
  std::unique_ptr<RibTransfer> geogrid_;
  std::unique_ptr<FieldFrames> frames_;
  double mean_size_ = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius_ = 0; // [m]
  double geogrid_height_ = 0;     // of its middle plane [m]
  double dt_ = 0;                 // [s]
  int surcharge_plate_ = -1;      // wall; -1: none

  double time_ = 0; // [s]
  std::int64_t steps_ = 0;
  dem::Vector3 clamp_velocity_ = dem::Vector3::Zero();
  Summary summary_;
  Clock::time_point stage_start_, run_start_;
  double stage_time_ = 0;
  std::int64_t stage_steps_ = 0;

  // Of the pull.
  double impulse_ = 0, impulse_time_ = 0; // of the pull force since the last record [N s], [s]
  double plate_impulse_ = 0;              // of the surcharge plate [N s]
  double pull_start_ = 0;                 // [s]
  std::vector<double> record_forces_;     // means between records [N]
  std::vector<double> filtered_forces_;   // means over the last millimetre [N]
  std::vector<double> record_displacements_;
  EnergyLedger ledger_at_pull_, ledger_;
  double largest_overlap_ = 0;          // in the pull, of all contacts [m]
  double largest_axial_force_ = 0;      // in the pull, of all ribs at the records [N]
  double largest_stretch_ = 0;          // the same [-]
  double smallest_stable_step_ = 1e300; // at the records of the pull [s]
  int n_lost_ = 0;                      // stones that fell out of the slot
};
} // namespace interlock::coupling
