#include "coupling/stones/settling.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
// So many steps between two looks at the kinetic energy, which costs about half a step.
constexpr int steps_between_looks = 200;
// Below a wall that keeps a force stones are not still before it presses with so much of it: they may
// lie still while it is still on its way, or on the first stone that it meets [-].
constexpr double pressing_share = 0.9;
// Most waits are over so long after their least time [s].
constexpr double usual_time = 0.3;
} // namespace

Stillness stillness(const Settling& settling, const World& world,
                    const SettlingParameters& parameters)
{
  const double waited = world.clock.time() - settling.begin;
  if (waited >= settling.least && world.clock.step % steps_between_looks == 0) {
    const double weight = parameters.gravity * world.engine.mass();
    const double target =
        settling.looseness * parameters.kinetic_energy_ratio * weight * parameters.mean_size;
    if (world.engine.controlled_walls_press(pressing_share) && world.kinetic_energy() < target)
      return Stillness::still;
  }
  return waited >= settling.least + parameters.time_limit ? Stillness::timed_out
                                                          : Stillness::moving;
}

bool has_settled(const Settling& settling, const World& world, const SettlingParameters& parameters,
                 RunRecords& records)
{
  const Stillness now = stillness(settling, world, parameters);
  if (now == Stillness::timed_out)
    records.warn(fmt::format("The stones had not settled after {:.3g} s in stage \"{}\".",
                             settling.least + parameters.time_limit, records.stage_name()));
  return now != Stillness::moving;
}

double fraction_of(const Settling& settling, const World& world)
{
  const double waited = world.clock.time() - settling.begin, usual = settling.least + usual_time;
  return waited < usual ? waited / usual : -1;
}
} // namespace interlock::coupling
