// The stages of a triaxial run: what each of them remembers. What a stage is:
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
class Triaxial;
class RunRecords;

// Lowers the plate, switches gravity off and lets the sides press, too: plate and sides keep the
// pressure of the compaction. Then gives the stones the friction of the test, lowers the pressure
// to that of the cell, and lets them settle with local damping and without.
struct IsotropicStage {
  static constexpr const char* kind = "consolidate";
  enum class Phase { begin, plate, cell, test_friction, free };
  Phase phase = Phase::begin;
  Settling settling;
};

// Moves the plate down; the sides keep their pressure.
struct CompressStage {
  static constexpr const char* kind = "compress";
  bool begun = false, over = false;
  bool is_last = false, record_due = false, frame_due = false; // of the step to come
  double begin = 0;                                            // [s]
  dem::Vector3 size_at_begin = dem::Vector3::Zero();           // length, width, height [m]
  int records = 0, frames = 0;
  // Since the last record.
  dem::Vector3 stress_impulse = dem::Vector3::Zero(); // across x, y, z [Pa s]
  double impulse_time = 0;                            // [s]
  // At the records; stresses are means between them, positive in compression.
  std::vector<double> strains;                   // axial [-]
  std::vector<double> heights, volumes;          // of the block [m], [m3]
  std::vector<double> axial, across_x, across_y; // stresses [Pa]
  EnergyLedger ledger_at_begin, ledger;          // at the first and last record
  ContactWatch watch;
};

void unite_notes(CompressStage& stage, Triaxial& test);
StageStatus before_step(FillStage& stage, Triaxial& test, RunRecords& records);
StageStatus before_step(IsotropicStage& stage, Triaxial& test, RunRecords& records);
StageStatus before_step(CompressStage& stage, Triaxial& test, RunRecords& records);
template <class Stage> void look(Stage&, Triaxial&, RunRecords&) {}
void look(CompressStage& stage, Triaxial& test, RunRecords& records);
template <class Stage> void after_step(Stage&, Triaxial&, RunRecords&) {}
void after_step(IsotropicStage& stage, Triaxial& test, RunRecords& records);
void after_step(CompressStage& stage, Triaxial& test, RunRecords& records);

inline std::string stage_name(const IsotropicStage&)
{
  return IsotropicStage::kind;
}
inline std::string stage_name(const CompressStage&)
{
  return CompressStage::kind;
}

template <class Archive> void exchange(Archive& archive, IsotropicStage& stage)
{
  archive("phase", stage.phase);
  archive("settling", stage.settling);
}
template <class Archive> void exchange(Archive& archive, CompressStage& stage)
{
  archive("begun", stage.begun);
  archive("over", stage.over);
  archive("begin", stage.begin, "s");
  archive("size_at_begin", stage.size_at_begin, "m");
  archive("records", stage.records);
  archive("frames", stage.frames);
  archive("stress_impulse", stage.stress_impulse, "Pa s");
  archive("impulse_time", stage.impulse_time, "s");
  archive("strains", stage.strains);
  archive("heights", stage.heights, "m");
  archive("volumes", stage.volumes, "m3");
  archive("axial", stage.axial, "Pa");
  archive("across_x", stage.across_x, "Pa");
  archive("across_y", stage.across_y, "Pa");
  archive("ledger_at_begin", stage.ledger_at_begin);
  archive("ledger", stage.ledger);
  exchange(archive, stage.watch);
}
} // namespace interlock::coupling
