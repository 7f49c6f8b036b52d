#pragma once

#include "coupling/run/forecast.h"

namespace interlock::coupling
{
class Heap;

// What a heap that has been prepared will take (forecast.h): the drop as planned, then until rest.
Forecast forecast(const Heap& heap);
} // namespace interlock::coupling
