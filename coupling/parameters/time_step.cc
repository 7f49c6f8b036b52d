#include "coupling/parameters/time_step.h"

#include "dem/input_error.h"

#include <cstdio>

namespace interlock::coupling
{
double choose_time_step(const TimeParameters& time, const dem::StableStep& stable)
{
  if (time.step == 0) return time.safety_factor * stable.step;
  if (time.step <= stable.step) return time.step;
  char sentence[256];
  std::snprintf(
      sentence, sizeof sentence,
      "Entry Time/Step is %.3g s, above the stable step of %.3g s, which shape %d of %.3g g with "
      "%d contacts sets (allowed: 0 for automatic, or up to %.3g s).",
      time.step, stable.step, stable.shape + 1, 1e3 * stable.mass, stable.contacts, stable.step);
  throw InputError(sentence);
}

StepRule step_rule(const TimeParameters& time, const dem::StableStep& stable)
{
  return {time.step > 0 ? 0 : time.safety_factor, stable.step};
}

void declare_time(ParameterTable& table, TimeParameters& time)
{
  table.open_section("Time");
  table.offer("Step", time.step, 0, not_negative,
              "Time step; 0: the safety factor times the stable step. [s]");
  table.offer("Safety factor", time.safety_factor, 0.2, {0, 1, false},
              "Time step as a share of the stable one. [-]");
}

std::string time_step_budget(double step, const dem::StableStep& stable)
{
  char sentence[320];
  std::snprintf(
      sentence, sizeof sentence,
      "time step %.3g us = %.3g x the expected stable step of %.3g us: shape %d of %.3g g with %d "
      "contacts of %.3g N/m, of whose mobility rotation makes %.0f %%",
      1e6 * step, step / stable.step, 1e6 * stable.step, stable.shape + 1, 1e3 * stable.mass,
      stable.contacts, stable.stiffness, 100 * stable.rotation_share);
  return sentence;
}
} // namespace interlock::coupling
