// The second stage of a strength test: walls come to press on the stones, which then get the
// friction of the test. Which walls and with how much is up to the experiment: its before_step
// waits, moves walls by the phase that is over, and enters the next one.
#pragma once

#include "coupling/run/stage.h"
#include "coupling/strength_test/specimen.h"

namespace interlock::coupling
{
struct ConsolidateStage {
  static constexpr const char* kind = "consolidate";
  // What is waited for: the plate presses; the sides press, too (only where they move); the stones
  // have the friction of the test; they have no local damping any more.
  enum class Phase { begin, plate, sides, test_friction, free };
  Phase phase = Phase::begin;
  Settling settling;
};
inline std::string stage_name(const ConsolidateStage&)
{
  return ConsolidateStage::kind;
}
template <class Archive> void exchange(Archive& archive, ConsolidateStage& stage)
{
  archive("phase", stage.phase);
  archive("settling", stage.settling);
}

// Whether the stones still have the friction of the filling, and walls press with
// Specimen::first_stress.
inline bool compacts(ConsolidateStage::Phase phase)
{
  return phase < ConsolidateStage::Phase::test_friction;
}
// True until the stones have settled; from then on every rank has all of them.
bool waits(const ConsolidateStage& stage, Specimen& specimen, RunRecords& records);
// Begins a phase: friction or damping of the stones, and the wait.
StageStatus enter(ConsolidateStage& stage, ConsolidateStage::Phase phase, Specimen& specimen);
} // namespace interlock::coupling
