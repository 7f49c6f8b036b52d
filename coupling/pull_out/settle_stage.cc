#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"

#include <fmt/format.h>

namespace interlock::coupling
{
StageStatus before_step(SettleStage& stage, PullOut& experiment, RunRecords& records)
{
  experiment.drop_lost_stones();
  World& world = experiment.world();
  const auto wait = [&](SettleStage::Phase phase) {
    stage.phase = phase;
    stage.settling = begin_settling(world, settling_after_removal, still);
  };
  if (stage.phase == SettleStage::Phase::begin) {
    experiment.end_filling();
    wait(SettleStage::Phase::damped);
  }
  if (!experiment.has_settled(stage.settling, records))
    return running(fraction_of(stage.settling, world));
  if (stage.phase == SettleStage::Phase::damped) {
    world.engine.set_local_damping(0);
    wait(SettleStage::Phase::free);
    return running(0.5);
  }
  world.make_whole();
  const dem::StableStep live = world.stable_step();
  describe_packing(experiment, records);
  return finished(fmt::format("kinetic energy {:.2g} J; live stable step {:.3g} us, set by a stone "
                              "of {:.1f} g with {} contacts",
                              world.kinetic_energy(), 1e6 * live.step, 1e3 * live.mass,
                              live.contacts));
}
} // namespace interlock::coupling
