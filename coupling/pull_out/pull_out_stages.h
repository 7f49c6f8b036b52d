// The stages of a pull-out run: what each of them remembers. What a stage is: coupling/run/stage.h.
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/run/stage.h"
#include "coupling/stones/filling.h"
#include "coupling/stones/settling.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
class PullOut;
class RunRecords;

// Presses what stands out of the surface down with a plate that moves at a prescribed speed, until
// it is at `height` or the stones carry the force limit; then lifts the plate off. Of a half
// that was weighed in it warns where it stops by more than the tolerance of protocol.h above the
// height.
struct FlattenStage {
  static constexpr const char* kind = "flatten";
  enum class Phase { begin, pressing, lifting, settling };
  std::string title; // in the log
  double height = 0; // [m]
  Phase phase = Phase::begin;
  dem::WallId plate = -1;
  double from = 0, reached = 0; // heights of the plate [m]
  double largest_force = 0;     // [N]
  Settling settling = {};
};

// Puts the geogrid on the surface, takes out the stones in the way of its ribs, opens the slot.
struct PlaceStage {
  static constexpr const char* kind = "place geogrid";
  bool placed = false;
  int taken_out = 0; // stones
  Settling settling;
};

// Heavy spheres on the surface that weigh the given force together (section 4 of the paper), or a
// plate that keeps it.
struct LoadStage {
  static constexpr const char* kind = "surcharge";
  bool loaded = false;
  int spheres = 0;
  Settling settling;
};

// A packed state takes over what is new in this run: contacts, load, slot, time step
// (start_from.h).
struct AdaptStage {
  static constexpr const char* kind = "adapt";
  bool looked = false;
};

// Before the pull: with local damping, then without, since that holds stones up a little.
struct SettleStage {
  static constexpr const char* kind = "settle";
  enum class Phase { begin, damped, free };
  Phase phase = Phase::begin;
  Settling settling;
};

// Moves the clamp: half a cosine from rest to full speed, then constant. A start with a jump would
// send a wave through the ribs.
struct PullStage {
  static constexpr const char* kind = "pull";
  bool begun = false, over = false;
  // Of the step to come; an extra frame is one of Output/Frames at.
  bool is_last = false, record_due = false, frame_due = false, extra_frame_due = false;
  double begin = 0;             // [s]
  double next_displacement = 0; // after the step to come [m]
  double displacement = 0;      // of the clamp [m]
  int records = 0, frames = 0;
  double impulse = 0, impulse_time = 0;     // of the pull force since the last record [N s], [s]
  double plate_impulse = 0;                 // of the surcharge plate since the begin [N s]
  std::vector<double> record_displacements; // [m]
  std::vector<double> record_forces;        // means between records [N]
  std::vector<double> filtered_forces;      // means over the last millimetre [N]
  EnergyLedger ledger_at_begin, ledger;     // at the first and the last record
  double largest_overlap = 0;               // of all contacts and steps [m]
  double largest_axial_force = 0;           // of all ribs at the records [N]
  double largest_stretch = 0;               // the same [-]
  double smallest_stable_step = 1e300;      // at the records [s]
  // Displacements from which on bounds of a usable pull were left (protocol.h); negative: never.
  // The ledger may come back, the others count for good [m].
  double ledger_left_at = -1, overlap_left_at = -1, stretch_left_at = -1;
  std::string wedge;      // wedged_stone() at the first record that finds one (wedge.h)
  double wedged_from = 0; // displacement of that record [m]
};

void unite_notes(PullStage& stage, PullOut& experiment);
// Each in a file of its own name (fill_stage.cc, ...).
StageStatus before_step(FillStage& stage, PullOut& experiment, RunRecords& records);
StageStatus before_step(FlattenStage& stage, PullOut& experiment, RunRecords& records);
StageStatus before_step(PlaceStage& stage, PullOut& experiment, RunRecords& records);
StageStatus before_step(LoadStage& stage, PullOut& experiment, RunRecords& records);
StageStatus before_step(AdaptStage& stage, PullOut& experiment, RunRecords& records);
StageStatus before_step(SettleStage& stage, PullOut& experiment, RunRecords& records);
StageStatus before_step(PullStage& stage, PullOut& experiment, RunRecords& records);
// Most stages measure nothing while they run.
template <class Stage> void look(Stage&, PullOut&, RunRecords&) {}
void look(AdaptStage& stage, PullOut& experiment, RunRecords& records);
void look(PullStage& stage, PullOut& experiment, RunRecords& records);
template <class Stage> void after_step(Stage&, PullOut&, RunRecords&) {}
void after_step(FlattenStage& stage, PullOut& experiment, RunRecords& records);
void after_step(PullStage& stage, PullOut& experiment, RunRecords& records);

template <class Stage> std::string stage_name(const Stage&)
{
  return Stage::kind;
}
inline std::string stage_name(const FlattenStage& stage)
{
  return stage.title;
}
// Other runs may start with the placing of their geogrid, or with their pull.
inline std::string start_state(const PlaceStage&)
{
  return "state_before_geogrid.h5";
}
inline std::string start_state(const PullStage&)
{
  return "state_before_pull.h5";
}

template <class Archive> void exchange(Archive& archive, FlattenStage& stage)
{
  archive("title", stage.title);
  archive("height", stage.height, "m");
  archive("phase", stage.phase);
  archive("plate", stage.plate);
  archive("from", stage.from, "m");
  archive("reached", stage.reached, "m");
  archive("largest_force", stage.largest_force, "N");
  archive("settling", stage.settling);
}
template <class Archive> void exchange(Archive& archive, PlaceStage& stage)
{
  archive("placed", stage.placed);
  archive("taken_out", stage.taken_out);
  archive("settling", stage.settling);
}
template <class Archive> void exchange(Archive& archive, LoadStage& stage)
{
  archive("loaded", stage.loaded);
  archive("spheres", stage.spheres);
  archive("settling", stage.settling);
}
template <class Archive> void exchange(Archive& archive, AdaptStage& stage)
{
  archive("looked", stage.looked);
}
template <class Archive> void exchange(Archive& archive, SettleStage& stage)
{
  archive("phase", stage.phase);
  archive("settling", stage.settling);
}
template <class Archive> void exchange(Archive& archive, PullStage& stage)
{
  archive("begun", stage.begun);
  archive("over", stage.over);
  archive("begin", stage.begin, "s");
  archive("displacement", stage.displacement, "m");
  archive("records", stage.records);
  archive("frames", stage.frames);
  archive("impulse", stage.impulse, "N s");
  archive("impulse_time", stage.impulse_time, "s");
  archive("plate_impulse", stage.plate_impulse, "N s");
  archive("record_displacements", stage.record_displacements, "m");
  archive("record_forces", stage.record_forces, "N");
  archive("filtered_forces", stage.filtered_forces, "N");
  archive("ledger_at_begin", stage.ledger_at_begin);
  archive("ledger", stage.ledger);
  archive("largest_overlap", stage.largest_overlap, "m");
  archive("largest_axial_force", stage.largest_axial_force, "N");
  archive("largest_stretch", stage.largest_stretch);
  archive("smallest_stable_step", stage.smallest_stable_step, "s");
  archive("ledger_left_at", stage.ledger_left_at, "m");
  archive("overlap_left_at", stage.overlap_left_at, "m");
  archive("stretch_left_at", stage.stretch_left_at, "m");
  archive("wedge", stage.wedge);
  archive("wedged_from", stage.wedged_from, "m");
}
} // namespace interlock::coupling
