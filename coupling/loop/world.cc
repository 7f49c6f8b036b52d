#include "coupling/loop/world.h"

#include "coupling/loop/stopwatch.h"

#include <algorithm>

namespace interlock::coupling
{
World::World(std::vector<dem::ClumpShape> shapes, const dem::ContactProperties& stone_on_stone,
             const dem::ContactProperties& stone_on_rib, double gravity)
    : engine(std::move(shapes), stone_on_stone, gravity), ribs(engine, stone_on_rib)
{
}

void World::place_geogrid(std::unique_ptr<RibTransfer> geogrid)
{
  geogrid_ = std::move(geogrid);
  ribs.place_geogrid(*geogrid_);
}

void World::attach_geogrid(std::unique_ptr<RibTransfer> geogrid)
{
  geogrid_ = std::move(geogrid);
  ribs.attach(*geogrid_);
}

void World::compute_forces()
{
  if (is_whole()) {
    engine.compute_forces(clock.dt);
    return;
  }
  const Stopwatch watch(times_.forces);
  engine.compute_forces(clock.dt);
  ++times_.steps;
}

void World::follow_stable_step()
{
  if (step_rule.share == 0) return;
  clock.set_step(step_rule.step(stable_step()));
  ribs.forget_substeps();
}

bool World::keep_below_stable_step()
{
  if (step_rule.share == 0) return false;
  const double step = step_rule.step(stable_step());
  // Some room: a step that follows every contact would change at every look.
  constexpr double room = 1.05;
  if (clock.dt <= room * step) return false;
  clock.set_step(step);
  return true;
}

void World::move()
{
  if (!held) ribs.move(clock.dt, clamp_velocity);
  ++clock.step;
}

EnergyLedger World::ledger() const
{
  EnergyLedger ledger = ribs.ledger(clock.dt);
  ledger.inserted += inserted;
  return ledger;
}

int World::touching_ribs() const
{
  const auto& contacts = ribs.rib_contacts().contacts();
  return static_cast<int>(sum_of_parts(static_cast<double>(
      std::count_if(contacts.begin(), contacts.end(), [](auto& c) { return c.overlap > 0; }))));
}

double World::largest_overlap() const
{
  double largest = engine.largest_overlap();
  for (const dem::RibContact& c : ribs.rib_contacts().contacts())
    largest = std::max(largest, c.overlap);
  return largest;
}
} // namespace interlock::coupling
