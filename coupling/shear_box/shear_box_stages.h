// The stages of a shear box run: what each of them remembers. What a stage is:
// coupling/run/stage.h.
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/run/stage.h"
#include "coupling/stones/contact_watch.h"
#include "coupling/stones/filling.h"
#include "coupling/stones/settling.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
class ShearBox;
class RunRecords;

// Lowers the plate, which from then on keeps its force; then gives the stones the friction of the
// test, and lets them settle with local damping and without.
struct ConsolidateStage {
  static constexpr const char* kind = "consolidate";
  enum class Phase { begin, loading, test_friction, free };
  Phase phase = Phase::begin;
  Settling settling;
};

// Moves the lower half.
struct ShearStage {
  static constexpr const char* kind = "shear";
  bool begun = false, over = false;
  bool is_last = false, record_due = false, frame_due = false; // of the step to come
  double begin = 0;                                            // [s]
  double plate_at_begin = 0;                                   // its height [m]
  double weight_above = 0; // of the stones above the plane, when it begins [N]
  int records = 0, frames = 0;
  // Since the last record.
  double shear_impulse = 0, normal_impulse = 0, plate_impulse = 0; // [N s]
  double impulse_time = 0;                                         // [s]
  // At the records; forces are means between them.
  std::vector<double> displacements, heights;                    // of the lower half, plate [m]
  std::vector<double> shear_forces, normal_forces, plate_forces; // [N]
  EnergyLedger ledger_at_begin, ledger;                          // at the first and last record
  ContactWatch watch;
};

void unite_notes(ShearStage& stage, ShearBox& box);
StageStatus before_step(FillStage& stage, ShearBox& box, RunRecords& records);
StageStatus before_step(ConsolidateStage& stage, ShearBox& box, RunRecords& records);
StageStatus before_step(ShearStage& stage, ShearBox& box, RunRecords& records);
template <class Stage> void look(Stage&, ShearBox&, RunRecords&) {}
void look(ShearStage& stage, ShearBox& box, RunRecords& records);
template <class Stage> void after_step(Stage&, ShearBox&, RunRecords&) {}
void after_step(ShearStage& stage, ShearBox& box, RunRecords& records);

inline std::string stage_name(const ConsolidateStage&)
{
  return ConsolidateStage::kind;
}
inline std::string stage_name(const ShearStage&)
{
  return ShearStage::kind;
}

template <class Archive> void exchange(Archive& archive, ConsolidateStage& stage)
{
  archive("phase", stage.phase);
  archive("settling", stage.settling);
}
template <class Archive> void exchange(Archive& archive, ShearStage& stage)
{
  archive("begun", stage.begun);
  archive("over", stage.over);
  archive("begin", stage.begin, "s");
  archive("plate_at_begin", stage.plate_at_begin, "m");
  archive("weight_above", stage.weight_above, "N");
  archive("records", stage.records);
  archive("frames", stage.frames);
  archive("shear_impulse", stage.shear_impulse, "N s");
  archive("normal_impulse", stage.normal_impulse, "N s");
  archive("plate_impulse", stage.plate_impulse, "N s");
  archive("impulse_time", stage.impulse_time, "s");
  archive("displacements", stage.displacements, "m");
  archive("heights", stage.heights, "m");
  archive("shear_forces", stage.shear_forces, "N");
  archive("normal_forces", stage.normal_forces, "N");
  archive("plate_forces", stage.plate_forces, "N");
  archive("ledger_at_begin", stage.ledger_at_begin);
  archive("ledger", stage.ledger);
  exchange(archive, stage.watch);
}
} // namespace interlock::coupling
