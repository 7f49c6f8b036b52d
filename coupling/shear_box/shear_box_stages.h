// The stages of a shear box run. What a stage is: coupling/run/stage.h.
#pragma once

#include "coupling/strength_test/consolidate_stage.h"
#include "coupling/strength_test/test_motion.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
class ShearBox;
class RunRecords;

// Moves the lower half.
struct ShearStage {
  static constexpr const char* kind = "shear";
  TestMotion motion;         // records shear, normal and plate force [N]
  double plate_at_begin = 0; // its height [m]
  double weight_above = 0;   // of the stones above the plane, when it begins [N]
  // At the records; forces are means between them.
  std::vector<double> displacements, heights;                    // of the lower half, plate [m]
  std::vector<double> shear_forces, normal_forces, plate_forces; // [N]
};

void unite_notes(ShearStage& stage, ShearBox& box);
StageStatus before_step(FillStage& stage, ShearBox& box, RunRecords& records);
// Lowers the plate, which from then on keeps its force.
StageStatus before_step(ConsolidateStage& stage, ShearBox& box, RunRecords& records);
StageStatus before_step(ShearStage& stage, ShearBox& box, RunRecords& records);
template <class Stage> void look(Stage&, ShearBox&, RunRecords&) {}
void look(ShearStage& stage, ShearBox& box, RunRecords& records);
template <class Stage> void after_step(Stage&, ShearBox&, RunRecords&) {}
void after_step(ShearStage& stage, ShearBox& box, RunRecords& records);

inline std::string stage_name(const ShearStage&)
{
  return ShearStage::kind;
}

template <class Archive> void exchange(Archive& archive, ShearStage& stage)
{
  exchange(archive, stage.motion);
  archive("plate_at_begin", stage.plate_at_begin, "m");
  archive("weight_above", stage.weight_above, "N");
  archive("shear_impulse", stage.motion.impulse.x(), "N s");
  archive("normal_impulse", stage.motion.impulse.y(), "N s");
  archive("plate_impulse", stage.motion.impulse.z(), "N s");
  archive("displacements", stage.displacements, "m");
  archive("heights", stage.heights, "m");
  archive("shear_forces", stage.shear_forces, "N");
  archive("normal_forces", stage.normal_forces, "N");
  archive("plate_forces", stage.plate_forces, "N");
}
} // namespace interlock::coupling
