// Starting a prescribed motion without a jump, which would send a wave through what it moves.
#pragma once

#include <cmath>

namespace interlock::coupling
{
// Share of the full speed after `elapsed` of `ramp_time` [s]: half a cosine from 0 to 1.
inline double soft_start(double elapsed, double ramp_time)
{
  if (elapsed >= ramp_time) return 1;
  return 0.5 * (1 - std::cos(M_PI * elapsed / ramp_time));
}
} // namespace interlock::coupling
