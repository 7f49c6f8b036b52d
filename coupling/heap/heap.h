// The heap experiment: stones fall one after the other on a flat floor and pile up (Ferellec and
// McDowell 2010, end of section 3).
//
// Frame: z up from the floor, x = y = 0 in the middle of the disc from which the stones fall.
#pragma once

#include "coupling/heap/drop_plan.h"
#include "coupling/heap/heap_measures.h"
#include "coupling/loop/energy_ledger.h"
#include "coupling/output/field_frames.h"
#include "coupling/output/history.h"
#include "coupling/output/monitor.h"
#include "coupling/output/summary.h"
#include "dem/engine/engine.h"

#include <chrono>
#include <filesystem>
#include <memory>

namespace interlock::coupling
{
class Heap
{
public:
  // Makes the clumps, plans the drop, checks the time step. Writes nothing. Throws InputError, one
  // full sentence, when a stone or the time step cannot be used.
  Heap(const HeapParameters& parameters, const Monitor& monitor);

  // Drops all stones, waits until they are at rest, and writes history.csv, fields, stones.csv,
  // profile.csv and summary.json into `output`, which must exist. Throws std::runtime_error when
  // the simulation fails, and lets pass what the monitor throws.
  Summary run(const std::filesystem::path& output);

private:
  using Clock = std::chrono::steady_clock;

  void begin_stage(const std::string& name);
  void end_stage(const std::string& result);
  void warn(const std::string& sentence);
  void step(double fraction);
  void watch();
  void release_due();
  void drop_lost_stones();
  void drop();
  void settle();
  void record();
  void write_stones(const std::filesystem::path& file) const;
  void write_profile(const std::filesystem::path& file, const SurfaceProfile& profile) const;
  void collect_results(const std::filesystem::path& output);
  void collect_measures(const std::filesystem::path& output);

  dem::Vector3 stone_centre(int clump) const;
  std::vector<HeapStone> stones() const;
  std::vector<dem::Sphere> spheres(bool touching_only) const; // in the world
  bool elongated(int clump) const;
  double weight() const; // [N]

  HeapParameters parameters_;
  Monitor monitor_;
  std::vector<Stone> stones_; // by shape
  std::vector<Release> plan_; // a clump's id is its index in here
  std::unique_ptr<dem::Engine> engine_;
  std::unique_ptr<FieldFrames> frames_;
  std::unique_ptr<History> history_;
  double mean_size_ = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius_ = 0; // [m]
  double dt_ = 0;                 // [s]

  double time_ = 0; // [s]
  std::int64_t steps_ = 0;
  double next_record_ = 0, next_frame_ = 0; // [s]
  double at_rest_time_ = 0;                 // after the last release [s]
  int n_lost_ = 0;                          // stones that rolled off the floor
  double longest_delay_ = 0;                // of a release, behind the plan [s]
  double largest_overlap_ = 0;              // of all steps [m]
  double smallest_stable_step_ = 1e300;     // at the records [s]
  EnergyLedger ledger_;
  Summary summary_;
  Clock::time_point run_start_, stage_start_;
  double stage_time_ = 0;
  std::int64_t stage_steps_ = 0;
};
} // namespace interlock::coupling
