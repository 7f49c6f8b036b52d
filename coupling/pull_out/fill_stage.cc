#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
const dem::Clumps& clumps_of(PullOut& experiment)
{
  return experiment.world().engine.clumps();
}

// Another round, or the levelling when the surface is high enough.
void pour_or_level(FillStage& stage, PullOut& experiment, const RunRecords& records)
{
  World& world = experiment.world();
  world.make_whole(); // the surface and the new stones are everybody's
  const BoxParameters& box = experiment.parameters().box;
  const double missing = stage.height - surface_height(clumps_of(experiment), box);
  if (stage.rounds < protocol::most_rounds &&
      missing > protocol::surface_tolerance * experiment.mean_size) {
    const double bulk_density =
        protocol::expected_solid_share * experiment.parameters().stones.density;
    Pouring pouring = experiment.pouring();
    // Several ranks stop at the end of a step only.
    if (world.n_ranks() == 1) pouring.poll = [&records] { records.throw_if_stop_requested(); };
    const double fall_time =
        pour(world.engine, box, pouring, bulk_density * box.length * box.width * missing);
    ++stage.rounds;
    stage.phase = FillStage::Phase::pouring;
    stage.settling = begin_settling(world, fall_time, loosely_still);
    return;
  }
  const std::vector<bool> excess = clumps_above(clumps_of(experiment), stage.height + stage.margin);
  stage.taken_off = static_cast<int>(std::count(excess.begin(), excess.end(), true));
  world.remove(excess);
  stage.phase = FillStage::Phase::levelling;
  stage.settling = begin_settling(world, protocol::settling_after_removal, loosely_still);
}
} // namespace

StageStatus before_step(FillStage& stage, PullOut& experiment, RunRecords& records)
{
  experiment.drop_lost_stones();
  if (stage.phase == FillStage::Phase::begin) pour_or_level(stage, experiment, records);
  if (experiment.has_settled(stage.settling, records)) {
    if (stage.phase == FillStage::Phase::levelling) {
      experiment.world().make_whole();
      const dem::Clumps& clumps = clumps_of(experiment);
      const BoxParameters& box = experiment.parameters().box;
      return finished(
          fmt::format("{} stones, {:.2f} kg, mean surface at {:.0f} mm; {} stones above "
                      "it were taken off",
                      stones(clumps), mass_in_box(clumps, box), 1e3 * surface_height(clumps, box),
                      stage.taken_off));
    }
    pour_or_level(stage, experiment, records);
  }
  return running(fraction_of(stage.settling, experiment.world()));
}
} // namespace interlock::coupling
