#include "coupling/stones/filling.h"

#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

void pour_and_wait(FillStage& stage, const Filling& filling, const RunRecords& records, double mass)
{
  World& world = filling.world;
  Pouring pouring = filling.pouring;
  // Several ranks stop at the end of a step only.
  if (world.n_ranks() == 1) pouring.poll = [&records] { records.throw_if_stop_requested(); };
  const double fall_time = pour(world.engine, filling.box, pouring, mass);
  ++stage.rounds;
  stage.phase = FillStage::Phase::pouring;
  stage.settling = begin_settling(world, fall_time, loosely_still);
}

// Pouring ends with the stone that brings the mass: half a stone too much in the mean.
double mass_to_nearest_stone(double mass, const Filling& filling)
{
  const double stone = M_PI / 6 * std::pow(filling.settling.mean_size, 3) * filling.pouring.density;
  return mass - 0.5 * stone;
}

// What another round should bring; 0: there is enough [kg].
double missing_mass(const FillStage& stage, const Filling& filling)
{
  if (stage.mass > 0) return mass_to_nearest_stone(stage.mass, filling);
  const BoxParameters& box = filling.box;
  const double missing = stage.height - surface_height(filling.world.engine.clumps(), box);
  const bool is_full = missing <= surface_tolerance * filling.settling.mean_size;
  if (stage.rounds >= most_rounds || is_full) return 0;
  const double bulk_density = expected_solid_share * filling.pouring.density;
  return bulk_density * box.length * box.width * missing;
}

void take_off_excess(FillStage& stage, World& world)
{
  stage.phase = FillStage::Phase::levelling;
  const std::vector<bool> excess = clumps_above(world.engine.clumps(), stage.height + stage.margin);
  stage.taken_off = static_cast<int>(std::count(excess.begin(), excess.end(), true));
  world.remove(excess);
  stage.settling = begin_settling(world, settling_after_removal, loosely_still);
}

// Another round, or the levelling when there is enough.
void pour_or_level(FillStage& stage, const Filling& filling, const RunRecords& records)
{
  filling.world.make_whole(); // the surface and the new stones are everybody's
  const double missing = missing_mass(stage, filling);
  if (missing > 0)
    pour_and_wait(stage, filling, records, missing);
  else
    take_off_excess(stage, filling.world);
}

std::string description(const FillStage& stage, const Filling& filling)
{
  const dem::Clumps& clumps = filling.world.engine.clumps();
  std::string text =
      fmt::format("{} stones, {:.2f} kg, mean surface at {:.0f} mm", stones(clumps),
                  mass_in_box(clumps, filling.box), 1e3 * surface_height(clumps, filling.box));
  if (stage.mass == 0) text += fmt::format("; {} stones above it were taken off", stage.taken_off);
  return text;
}
} // namespace

StageStatus fill(FillStage& stage, const Filling& filling, RunRecords& records)
{
  World& world = filling.world;
  if (stage.phase == FillStage::Phase::begin) pour_or_level(stage, filling, records);
  if (has_settled(stage.settling, world, filling.settling, records)) {
    if (stage.phase == FillStage::Phase::levelling || stage.mass > 0) {
      world.make_whole();
      return finished(description(stage, filling));
    }
    pour_or_level(stage, filling, records);
  }
  return running(fraction_of(stage.settling, world));
}
} // namespace interlock::coupling
