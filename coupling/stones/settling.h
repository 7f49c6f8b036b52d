// Waiting until stones lie still.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/run/run_records.h"

namespace interlock::coupling
{
struct SettlingParameters {
  double kinetic_energy_ratio = 0; // still when E_kin < ratio * weight * mean stone size [-]
  double time_limit = 0;           // after the least time; ends with a warning [s]
  double mean_size = 0;            // of a stone [m]
  double gravity = 0; // for the weight; that of the case, also where it is switched off [m/s2]
};

// How still: small stones keep slipping into voids for long, which does not matter before the next
// stones fall on them.
constexpr double still = 1, loosely_still = 10;

// Times that stones are left to settle at least [s]: after some were taken off or out, about what a
// stone needs to fall into the hole of another one by half its size, ...
constexpr double settling_after_removal = 0.02;
// ... and below a new load, which has to compact the stones first.
constexpr double settling_below_load = 0.1;

// A wait in progress: a member of the stage that waits.
struct Settling {
  double begin = 0;     // [s]
  double least = 0;     // waits at least so long [s]
  double looseness = 1; // factor on the energy: still, loosely_still [-]
};
template <class Archive> void exchange(Archive& archive, Settling& settling)
{
  archive("begin", settling.begin, "s");
  archive("least", settling.least, "s");
  archive("looseness", settling.looseness);
}

// Still: little kinetic energy, and walls that keep a force press with it.
enum class Stillness { moving, still, timed_out };

inline Settling begin_settling(const World& world, double least, double looseness)
{
  return {world.clock.time(), least, looseness};
}
Stillness stillness(const Settling& settling, const World& world,
                    const SettlingParameters& parameters);
// Whether a stage may settle no longer: true when the stones lie still, and, with a warning, when
// the time limit has passed.
bool has_settled(const Settling& settling, const World& world, const SettlingParameters& parameters,
                 RunRecords& records);
// Of the wait, for a progress bar: nobody knows how long it takes. Negative when it takes longer
// than most [-].
double fraction_of(const Settling& settling, const World& world);
} // namespace interlock::coupling
