#include "coupling/stones/filling.h"

#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
// Poured stones fill about this share of the volume (clumps with their pores between them): rather
// too much than another round, the excess is taken off [-].
constexpr double expected_solid_share = 0.62;
// A filling that is not there after so many rounds does not get there: every round brings the
// surface about nine tenths of the missing height nearer.
constexpr int most_rounds = 8;
// The surface is as high as asked for when it is nearer than this share of a mean stone [-].
constexpr double surface_tolerance = 0.2;

// Another round, or the levelling when the surface is high enough.
void pour_or_level(FillStage& stage, const Filling& filling, const RunRecords& records)
{
  World& world = filling.world;
  world.make_whole(); // the surface and the new stones are everybody's
  const dem::Clumps& clumps = world.engine.clumps();
  const BoxParameters& box = filling.box;
  const double missing = stage.height - surface_height(clumps, box);
  if (stage.rounds < most_rounds && missing > surface_tolerance * filling.settling.mean_size) {
    const double bulk_density = expected_solid_share * filling.pouring.density;
    Pouring pouring = filling.pouring;
    // Several ranks stop at the end of a step only.
    if (world.n_ranks() == 1) pouring.poll = [&records] { records.throw_if_stop_requested(); };
    const double fall_time =
        pour(world.engine, box, pouring, bulk_density * box.length * box.width * missing);
    ++stage.rounds;
    stage.phase = FillStage::Phase::pouring;
    stage.settling = begin_settling(world, fall_time, loosely_still);
    return;
  }
  const std::vector<bool> excess = clumps_above(clumps, stage.height + stage.margin);
  stage.taken_off = static_cast<int>(std::count(excess.begin(), excess.end(), true));
  world.remove(excess);
  stage.phase = FillStage::Phase::levelling;
  stage.settling = begin_settling(world, settling_after_removal, loosely_still);
}
} // namespace

StageStatus fill(FillStage& stage, const Filling& filling, RunRecords& records)
{
  World& world = filling.world;
  if (stage.phase == FillStage::Phase::begin) pour_or_level(stage, filling, records);
  if (has_settled(stage.settling, world, filling.settling, records)) {
    if (stage.phase == FillStage::Phase::levelling) {
      world.make_whole();
      const dem::Clumps& clumps = world.engine.clumps();
      return finished(fmt::format(
          "{} stones, {:.2f} kg, mean surface at {:.0f} mm; {} stones above it were taken off",
          stones(clumps), mass_in_box(clumps, filling.box),
          1e3 * surface_height(clumps, filling.box), stage.taken_off));
    }
    pour_or_level(stage, filling, records);
  }
  return running(fraction_of(stage.settling, world));
}
} // namespace interlock::coupling
