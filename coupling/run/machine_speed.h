// How fast this machine makes steps at this moment, and how much memory this process has: for
// forecasts of what is to come on it.
#pragma once

#include "coupling/run/forecast.h"

namespace interlock::coupling
{
// Makes steps of a small packed box for some hundredths of a second of wall-clock time, other work
// of the machine included, and returns how many times longer one takes than on the machine of
// Forecast when that was quiet.
double measured_slowness();

// Puts what was measured into the forecast: Forecast::slowness and program_memory.
void measure_machine(Forecast& forecast);
} // namespace interlock::coupling
