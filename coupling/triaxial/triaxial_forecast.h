#pragma once

#include "coupling/run/forecast.h"

namespace interlock::coupling
{
class Triaxial;

// What a triaxial run that has been prepared will take (forecast.h).
Forecast forecast(const Triaxial& test);
} // namespace interlock::coupling
