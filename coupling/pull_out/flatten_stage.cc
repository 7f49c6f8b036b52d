#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
using Phase = FlattenStage::Phase;

void lower_plate(FlattenStage& stage, PullOut& experiment)
{
  experiment.world().make_whole();
  dem::Engine& engine = experiment.world().engine;
  stage.from = highest_point(engine.clumps(), stage.height);
  dem::Wall plate =
      box_plate("plate", experiment.parameters().box, experiment.stone_on_box(), stage.from);
  plate.velocity = {0, 0, -experiment.parameters().filling.plate_speed};
  stage.plate = engine.add_wall(plate);
  stage.phase = Phase::pressing;
}

void lift_plate(FlattenStage& stage, PullOut& experiment)
{
  dem::Wall& plate = experiment.world().engine.wall(stage.plate);
  stage.reached = plate.corner.z();
  plate.velocity = {0, 0, experiment.parameters().filling.plate_speed};
  stage.phase = Phase::lifting;
}

void take_plate_away(FlattenStage& stage, PullOut& experiment)
{
  World& world = experiment.world();
  world.make_whole();
  world.engine.remove_walls({stage.plate});
  stage.plate = -1;
  stage.phase = Phase::settling;
  stage.settling = begin_settling(world, protocol::settling_after_plate, loosely_still);
}

// A mass was asked for, and has to fit below the plate.
bool is_weighed_in(const FlattenStage& stage, const PullOut& experiment)
{
  const FillingParameters& filling = experiment.parameters().filling;
  const bool is_lower = stage.height < experiment.geogrid_height();
  return (is_lower ? filling.lower_bulk_density : filling.upper_bulk_density) > 0;
}

void warn_of_height(const FlattenStage& stage, const PullOut& experiment, RunRecords& records)
{
  if (!is_weighed_in(stage, experiment) ||
      stage.reached <= stage.height + protocol::level_tolerance * experiment.mean_size)
    return;
  records.warn(fmt::format(
      "The plate stopped at {:.1f} mm instead of {:.1f} in stage \"{}\": the stones below carry "
      "Filling/Plate force limit. Lower Filling/Stone friction or the bulk density, or raise it.",
      1e3 * stage.reached, 1e3 * stage.height, stage.title));
}
} // namespace

StageStatus before_step(FlattenStage& stage, PullOut& experiment, RunRecords& records)
{
  const auto plate = [&]() -> const dem::Wall& {
    return experiment.world().engine.wall(stage.plate);
  };
  if (stage.phase == Phase::begin) lower_plate(stage, experiment);
  if (stage.phase == Phase::pressing) {
    const double height = plate().corner.z();
    if (height > stage.height &&
        stage.largest_force < experiment.parameters().filling.plate_force_limit)
      return running(std::min(0.8, (stage.from - height) / (stage.from - stage.height)));
    lift_plate(stage, experiment);
    warn_of_height(stage, experiment, records);
  }
  // Until the plate is clear of the stones.
  if (stage.phase == Phase::lifting) {
    if (plate().force.z() > 0) return running(0.9);
    take_plate_away(stage, experiment);
  }
  if (!experiment.has_settled(stage.settling, records)) return running(0.95);
  return finished(fmt::format("plate down from {:.1f} to {:.1f} mm, largest force {:.0f} N",
                              1e3 * stage.from, 1e3 * stage.reached, stage.largest_force));
}

void after_step(FlattenStage& stage, PullOut& experiment, RunRecords&)
{
  if (stage.phase != Phase::pressing) return;
  stage.largest_force =
      std::max(stage.largest_force, experiment.world().engine.wall(stage.plate).force.z());
}
} // namespace interlock::coupling
