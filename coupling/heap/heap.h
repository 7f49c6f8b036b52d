// The heap experiment: stones fall one after the other on a flat floor and pile up (Ferellec and
// McDowell 2010, end of section 3).
//
// Frame: z up from the floor, x = y = 0 in the middle of the disc from which the stones fall.
#pragma once

#include "coupling/heap/drop_plan.h"
#include "coupling/heap/heap_measures.h"
#include "coupling/heap/heap_stages.h"
#include "coupling/loop/energy_ledger.h"
#include "coupling/loop/world.h"
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_records.h"
#include "coupling/run/run_request.h"

#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
class Heap
{
public:
  static constexpr const char* name = "heap";
  using Stage = std::variant<DropStage, HeapSettleStage>;

  // Floor and walls, but no stones yet: for reading a state into. Throws InputError when the file
  // of the wall of triangles cannot be used.
  explicit Heap(const HeapParameters& parameters);

  // Makes the stones, plans the drop, checks the time step. Throws InputError, one full sentence,
  // when a stone or the time step cannot be used.
  void prepare(const Monitor& monitor, const std::vector<CaseEntry>& entries);

  std::vector<Stage> plan() const { return {DropStage(), HeapSettleStage()}; }
  std::vector<std::string> history_columns() const;
  PhysicsLimits limits() const { return {}; }
  void begin(RunRecords& records) const;                          // logs the preparation
  const std::string& preparation() const { return preparation_; } // what was made, for the log
  // Writes stones.csv and profile.csv, too.
  void finish(std::vector<Stage>& plan, RunRecords& records) const;

  World& world() { return world_; }
  const World& world() const { return world_; }
  const HeapParameters& parameters() const { return parameters_; }

  // Whether a row of history.csv or a frame is due.
  bool is_record_due() const { return is_row_due() || is_frame_due(); }
  // Writes what is due, or both anyway.
  void record_when_due(RunRecords& records, bool anyway = false);
  // Keeps the largest overlap of the step that was made.
  void note_overlap();
  void unite_notes() { largest_overlap = world_.largest(largest_overlap); }
  // Takes out what rolled over the edge of the floor: it would fall for ever.
  void drop_lost_stones();

  std::vector<Stone> stones;     // by shape
  std::vector<Release> releases; // planned; a clump's id is its index in here
  double mean_size = 0;          // of a stone: diameter of the ball of equal mean volume [m]
  double mean_sphere_radius = 0; // [m]
  // Of the run so far.
  std::int64_t rows = 0, frames = 0;   // written, of those at whole intervals
  int lost = 0;                        // stones that rolled off the floor
  double longest_delay = 0;            // of a release, behind the plan [s]
  double at_rest_time = 0;             // after the last release [s]
  double largest_overlap = 0;          // of all steps [m]
  double smallest_stable_step = 1e300; // at the records [s]
  EnergyLedger ledger;                 // of the last record

private:
  bool is_row_due() const;
  bool is_frame_due() const;

  HeapParameters parameters_;
  World world_;
  std::string preparation_;             // what it made, for the log
  std::vector<std::string> wall_notes_; // on the file of the mesh wall
  double preparation_time_ = 0;         // wall-clock [s]
};

template <class Archive> void exchange(Archive& archive, Heap& heap)
{
  archive("stones", heap.stones);
  archive("releases", heap.releases);
  archive("mean_stone_size", heap.mean_size, "m");
  archive("mean_sphere_radius", heap.mean_sphere_radius, "m");
  archive("rows", heap.rows);
  archive("frames", heap.frames);
  archive("lost_stones", heap.lost);
  archive("longest_delay", heap.longest_delay, "s");
  archive("at_rest_time", heap.at_rest_time, "s");
  archive("largest_overlap", heap.largest_overlap, "m");
  archive("smallest_stable_step", heap.smallest_stable_step, "s");
  archive("ledger", heap.ledger);
  archive("world", heap.world());
}
} // namespace interlock::coupling
