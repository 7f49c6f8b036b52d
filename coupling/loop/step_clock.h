// The time of a run: a count of steps, so that no sum of steps collects rounding.
#pragma once

#include <cstdint>

namespace interlock::coupling
{
struct StepClock {
  std::int64_t step = 0; // steps since the start of the run
  double dt = 0;         // of the steps to come [s]
  // Where the present dt has been used from on.
  std::int64_t origin_step = 0;
  double origin_time = 0; // [s]

  double time() const // [s]
  {
    return origin_time + static_cast<double>(step - origin_step) * dt;
  }
  void set_step(double new_dt)
  {
    origin_time = time();
    origin_step = step;
    dt = new_dt;
  }
};

template <class Archive> void exchange(Archive& archive, StepClock& clock)
{
  archive("step", clock.step);
  archive("dt", clock.dt, "s");
  archive("origin_step", clock.origin_step);
  archive("origin_time", clock.origin_time, "s");
}
} // namespace interlock::coupling
