// What a run will take, in one line, before it begins.
#pragma once

#include "coupling/run/forecast.h"

#include <string>

namespace interlock::apps
{
// "About 3:10 min at the present speed of this machine, 220 MB of memory, 64 MB of files (41 frames
// of 1.4 MB); estimates, good to a factor of two for hundreds of stones." With several ranks the
// time is what they share. Empty where the experiment has no stages.
std::string cost_text(const coupling::Forecast& forecast, int ranks);
} // namespace interlock::apps
