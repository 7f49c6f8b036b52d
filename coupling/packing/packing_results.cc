// What a packing run leaves in its summary: what a step costs, and whether the box stands.
#include "coupling/packing/packing.h"

#include <fmt/format.h>

#include <cmath>

namespace interlock::coupling
{
namespace
{
void describe_speed(const TimedStage& timed, const World& world, RunRecords& records)
{
  Summary& summary = records.summary;
  const double steps = static_cast<double>(timed.steps);
  summary.wall_time_per_step = timed.timer.seconds / steps;
  const double whole = summary.wall_time_per_step;
  // Records, checks and the screen are outside of the time of a step; they are given beside it.
  const double outside = summary.stages.back().wall_time - timed.timer.seconds;
  const std::pair<const char*, double> parts[] = {
      {"broad_phase", timed.profile.broad_phase / steps},
      {"lists", timed.profile.lists / steps},
      {"contacts", timed.profile.contacts / steps},
      {"integration", timed.profile.integration / steps}};
  std::string table = fmt::format("a step takes {:.6f} ms ({} steps/s), of which", 1e3 * whole,
                                  std::lround(1 / whole));
  for (const auto& [part, seconds] : parts) {
    summary.results[std::string(part) + "_s_per_step"] = seconds;
    table +=
        fmt::format("\n  {:<12} {:10.3f} us {:6.1f} %", part, 1e6 * seconds, 100 * seconds / whole);
  }
  summary.results["output_s_per_step"] = outside / steps;
  const dem::ListCounts lists = world.engine.profile().counts;
  summary.results["list_builds"] = {{"clump_pairs", lists.outer_builds},
                                    {"sphere_pairs", lists.middle_builds},
                                    {"about_to_touch", lists.inner_builds}};
  summary.results["list_sizes"] = {{"clump_pairs", lists.clump_pairs},
                                   {"sphere_pairs", lists.candidates},
                                   {"about_to_touch", lists.lanes}};
  table +=
      fmt::format("\n  {:<12} {:10.3f} us besides, with checks", "output", 1e6 * outside / steps);
  records.message(table + "\n  state hash " + hexadecimal(summary.state_hash));
}

void describe_energies(const TimedStage& timed, const World& world, RunRecords& records)
{
  add_ledger(records.summary, timed.ledger);
  warn_of_ledger(timed.ledger, records);
  records.summary.ledger_closes = timed.ledger.relative_error() <= ledger_failure;
  const dem::StableStep live = world.stable_step();
  if (live.step > 0 && world.clock.dt > live.step)
    records.warn(fmt::format("The time step of {:.3g} s is above the live stable step of {:.3g} s.",
                             world.clock.dt, live.step));
}
} // namespace

void Packing::finish(std::vector<Stage>& plan, RunRecords& records) const
{
  const TimedStage& timed = std::get<TimedStage>(plan.back());
  Summary& s = records.summary;
  s.seed = parameters_.state.seed;
  const double steps = static_cast<double>(timed.steps), weight = world_.weight();
  const double floor = timed.floor.value() / steps, sides = timed.side_walls.value() / steps;
  s.results["kinetic_energy_J"] = timed.ledger.kinetic_stones;
  // Means over the timed steps; downwards.
  s.results["floor_force_N"] = floor;
  s.results["side_wall_friction_N"] = sides;
  s.results["weight_N"] = weight;
  if (weight > 0 && !world_.held)
    s.results["carried_weight_over_weight"] = (floor + sides) / weight;
  s.results["missed_contact_checks"] = parameters_.state.missed_contact_checks;
  s.results["timed_steps"] = timed.steps;
  describe_speed(timed, world_, records);
  if (!world_.held) describe_energies(timed, world_, records);
}
} // namespace interlock::coupling
