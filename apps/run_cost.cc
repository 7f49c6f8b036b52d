#include "apps/run_cost.h"

#include "apps/progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::apps
{
std::string cost_text(const coupling::Forecast& forecast, const int ranks)
{
  if (forecast.stages.empty()) return "";
  std::string text = "About " + duration_text(std::max(1., forecast.time())) +
                     " at the present speed of this machine";
  if (ranks > 1) text += fmt::format(" for {} ranks to share", ranks);
  text += ", " + bytes_text(forecast.memory()) + " of memory, " + bytes_text(forecast.disk()) +
          " of files";
  if (forecast.frames > 0)
    text += fmt::format(" ({} frames of {:.2g} MB)", forecast.frames, 1e-6 * forecast.frame_size());
  return text + "; estimates, good to a factor of two for hundreds of stones.";
}
} // namespace interlock::apps
