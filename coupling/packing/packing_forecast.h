#pragma once

#include "coupling/run/forecast.h"

namespace interlock::coupling
{
class Packing;

// What a packing that has been prepared will take (forecast.h). All of its steps are in the case,
// none is waited for.
Forecast forecast(const Packing& packing);
} // namespace interlock::coupling
