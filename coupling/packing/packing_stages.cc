#include "coupling/packing/packing_stages.h"

#include "coupling/packing/packing.h"
#include "coupling/run/run_failure.h"

#include <fmt/format.h>

#include <cmath>

namespace interlock::coupling
{
namespace
{
// Whether one of `n` events, spread evenly over `total` steps, falls on this step; the last one
// falls on the last step.
bool is_due(std::int64_t step, std::int64_t n, std::int64_t total)
{
  return (step + 1) * n / total > step * n / total;
}

int touching_clump_pairs(const dem::Engine& engine)
{
  int pairs = 0, i = -1, j = -1;
  for (const dem::SphereContact& c : engine.sphere_contacts()) { // sorted by clumps
    if (!c.touching || (c.i == i && c.j == j)) continue;
    if (engine.clumps().ghost[c.i] == 1) continue; // another rank counts it
    i = c.i, j = c.j;
    ++pairs;
  }
  return pairs;
}

int touching_walls(const dem::Engine& engine)
{
  int contacts = 0;
  for (const dem::WallContact& c : engine.wall_contacts()) contacts += c.touching;
  return contacts;
}

void start(StepTimer& timer)
{
  timer.start = StepTimer::Clock::now();
  timer.runs = true;
}

void stop(StepTimer& timer)
{
  if (!timer.runs) return;
  timer.seconds += std::chrono::duration<double>(StepTimer::Clock::now() - timer.start).count();
  timer.runs = false;
}

// The floor is the first wall, the sides follow.
double side_wall_friction(const dem::Engine& engine)
{
  double sum = 0;
  for (std::size_t w = 1; w < engine.walls().size(); ++w) sum -= engine.walls()[w].force.z();
  return sum;
}

double floor_force(const dem::Engine& engine)
{
  return -engine.walls()[0].force.z();
}

void record(const TimedStage& stage, World& world, RunRecords& records)
{
  dem::Engine& engine = world.engine;
  engine.complete_wall_forces();
  const int spheres = world.touching_spheres();
  const double at_walls = world.sum_of_parts(touching_walls(engine));
  const double overlap = world.largest(world.largest_overlap());
  records.add({world.clock.time(), stage.ledger.kinetic_stones, double(spheres), at_walls, overlap,
               floor_force(engine), side_wall_friction(engine), stage.ledger.relative_error()});
  Summary& summary = records.summary;
  summary.contacts = spheres;
  summary.results["touching_sphere_pairs"] = spheres;
  summary.results["touching_clump_pairs"] =
      static_cast<int>(world.sum_of_parts(touching_clump_pairs(engine)));
  summary.results["wall_contacts"] = static_cast<int>(at_walls);
  summary.results["largest_overlap_m"] = overlap;
}

void check_for_missed_contacts(const World& world)
{
  const int listed = world.engine.n_touching_spheres(),
            there = world.engine.count_overlaps_brute_force();
  if (listed != there)
    throw RunFailure(
        fmt::format("At step {} the neighbour lists hold {} touching sphere pairs, but a "
                    "search of all pairs finds {}.",
                    world.clock.step, listed, there));
}
} // namespace

StageStatus before_step(WarmUpStage& stage, Packing& packing, RunRecords&)
{
  const int total = packing.parameters().warm_up_steps;
  stop(stage.timer);
  if (stage.done == total)
    return finished(fmt::format("{} steps, {:.4g} ms a step, kinetic energy {:.2g} J", total,
                                1e3 * stage.timer.seconds / total,
                                packing.world().kinetic_energy()));
  start(stage.timer);
  return running(double(stage.done) / total);
}

void after_step(WarmUpStage& stage, Packing&, RunRecords&)
{
  ++stage.done;
}

StageStatus before_step(TimedStage& stage, Packing& packing, RunRecords&)
{
  const PackingParameters& p = packing.parameters();
  const int total = p.timed_steps;
  stop(stage.timer);
  if (stage.done == total)
    return finished(
        fmt::format("{} of {} steps timed, between records and checks", stage.steps, total));
  const bool check_due = is_due(stage.done, p.state.missed_contact_checks, total);
  stage.look_due = check_due || is_due(stage.done, p.records, total);
  packing.world().engine.reset_profile();
  start(stage.timer);
  const double fraction = double(stage.done) / total;
  if (check_due) return running(fraction, Look::at_everything); // all pairs
  return running(fraction, stage.look_due ? Look::at_part : Look::none);
}

void unite_notes(TimedStage& stage, Packing& packing)
{
  const auto over_ranks = [&](double mine) { return packing.world().sum(mine); };
  stage.floor.unite(over_ranks);
  stage.side_walls.unite(over_ranks);
}

void look(TimedStage& stage, Packing& packing, RunRecords& records)
{
  const PackingParameters& p = packing.parameters();
  World& world = packing.world();
  if (!world.held) stage.ledger = world.ledger(); // stones that forces do not move have none
  if (is_due(stage.done, p.records, p.timed_steps)) record(stage, world, records);
  if (is_due(stage.done, p.state.missed_contact_checks, p.timed_steps))
    check_for_missed_contacts(world);
}

void after_step(TimedStage& stage, Packing& packing, RunRecords&)
{
  ++stage.done;
  if (stage.look_due) {
    stage.timer.runs = false;
    return;
  }
  ++stage.steps;
  const dem::Engine& engine = packing.world().engine;
  stage.floor.add(floor_force(engine)); // on this rank's part of the stones
  stage.side_walls.add(side_wall_friction(engine));
  const dem::StepProfile p = engine.profile();
  stage.profile.broad_phase += p.broad_phase;
  stage.profile.lists += p.lists;
  stage.profile.contacts += p.contacts;
  stage.profile.integration += p.integration;
}
} // namespace interlock::coupling
