// The stages of a triaxial run. What a stage is: coupling/run/stage.h.
#pragma once

#include "coupling/strength_test/consolidate_stage.h"
#include "coupling/strength_test/test_motion.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
class Triaxial;
class RunRecords;

// Moves the plate down; the sides keep their pressure.
struct CompressStage {
  static constexpr const char* kind = "compress";
  TestMotion motion;                                 // records stresses across x, y, z [Pa]
  dem::Vector3 size_at_begin = dem::Vector3::Zero(); // length, width, height [m]
  // At the records; stresses are means between them, positive in compression.
  std::vector<double> strains;                   // axial [-]
  std::vector<double> heights, volumes;          // of the block [m], [m3]
  std::vector<double> axial, across_x, across_y; // stresses [Pa]
};

void unite_notes(CompressStage& stage, Triaxial& test);
StageStatus before_step(FillStage& stage, Triaxial& test, RunRecords& records);
// Lowers the plate, switches gravity off and lets the sides press, too: plate and sides keep the
// pressure of the compaction, and that of the cell once the stones have the friction of the test.
StageStatus before_step(ConsolidateStage& stage, Triaxial& test, RunRecords& records);
StageStatus before_step(CompressStage& stage, Triaxial& test, RunRecords& records);
template <class Stage> void look(Stage&, Triaxial&, RunRecords&) {}
void look(CompressStage& stage, Triaxial& test, RunRecords& records);
template <class Stage> void after_step(Stage&, Triaxial&, RunRecords&) {}
void after_step(ConsolidateStage& stage, Triaxial& test, RunRecords& records);
void after_step(CompressStage& stage, Triaxial& test, RunRecords& records);

inline std::string stage_name(const CompressStage&)
{
  return CompressStage::kind;
}

template <class Archive> void exchange(Archive& archive, CompressStage& stage)
{
  exchange(archive, stage.motion);
  archive("size_at_begin", stage.size_at_begin, "m");
  archive("stress_impulse", stage.motion.impulse, "Pa s");
  archive("strains", stage.strains);
  archive("heights", stage.heights, "m");
  archive("volumes", stage.volumes, "m3");
  archive("axial", stage.axial, "Pa");
  archive("across_x", stage.across_x, "Pa");
  archive("across_y", stage.across_y, "Pa");
}
} // namespace interlock::coupling
