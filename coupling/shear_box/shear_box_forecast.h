#pragma once

#include "coupling/run/forecast.h"

namespace interlock::coupling
{
class ShearBox;

// What a shear box run that has been prepared will take (forecast.h).
Forecast forecast(const ShearBox& box);
} // namespace interlock::coupling
