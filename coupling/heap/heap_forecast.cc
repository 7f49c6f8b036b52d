#include "coupling/heap/heap_forecast.h"

#include "coupling/heap/heap.h"
#include "coupling/stones/stone_quality.h"

namespace interlock::coupling
{
// The case is at rest 5 to 9 s after the last stone [s].
constexpr double usual_settling_time = 7;

Forecast forecast(const Heap& heap)
{
  std::size_t spheres = 0;
  for (const Stone& stone : heap.stones) spheres += stone.shape.spheres.size();
  const double mean = static_cast<double>(spheres) / static_cast<double>(heap.stones.size());
  Forecast result;
  result.stones = heap.preparation();
  result.warnings = quality_warnings(heap.stones);
  result.clumps = static_cast<std::int64_t>(heap.releases.size());
  result.spheres = static_cast<std::int64_t>(mean * static_cast<double>(result.clumps));
  result.time_step = heap.world().clock.dt;
  const double drop = heap.releases.back().time, all = static_cast<double>(result.spheres);
  result.stages = {{"drop", drop, 0.5 * all, false}, {"settle", usual_settling_time, all, false}};
  const double interval = heap.parameters().output.frame_interval;
  result.frames =
      1 + (interval > 0 ? static_cast<int>((drop + usual_settling_time) / interval) : 0);
  return result;
}
} // namespace interlock::coupling
