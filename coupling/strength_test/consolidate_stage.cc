#include "coupling/strength_test/consolidate_stage.h"

namespace interlock::coupling
{
using Phase = ConsolidateStage::Phase;

bool waits(const ConsolidateStage& stage, Specimen& specimen, RunRecords& records)
{
  World& world = specimen.world();
  if (stage.phase != Phase::begin &&
      !has_settled(stage.settling, world, specimen.filling().settling, records))
    return true;
  world.make_whole();
  return false;
}

StageStatus enter(ConsolidateStage& stage, Phase phase, Specimen& specimen)
{
  World& world = specimen.world();
  if (phase == Phase::test_friction)
    world.engine.stone_contact().friction = specimen.parameters().contact.stone_friction;
  if (phase == Phase::free) world.engine.set_local_damping(0);
  stage.phase = phase;
  stage.settling = compacts(phase) ? begin_settling(world, settling_below_load, loosely_still)
                                   : begin_settling(world, settling_after_removal, still);
  return running(0);
}
} // namespace interlock::coupling
