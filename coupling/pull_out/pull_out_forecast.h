#pragma once

#include "coupling/run/forecast.h"

namespace interlock::coupling
{
class PullOut;

// What a pull-out that has been prepared and starts from an empty box will take (forecast.h). A run
// that starts from a packed state knows its stones; its filling is left out.
Forecast forecast(const PullOut& experiment);
} // namespace interlock::coupling
