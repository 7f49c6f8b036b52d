#include "coupling/packing/packing_forecast.h"

#include "coupling/packing/packing.h"

namespace interlock::coupling
{
Forecast forecast(const Packing& packing)
{
  const PackingParameters& p = packing.parameters();
  const dem::Clumps& clumps = packing.world().engine.clumps();
  Forecast result;
  result.clumps = clumps.size();
  result.spheres = clumps.n_spheres();
  result.time_step = packing.world().clock.dt;
  const auto spheres = static_cast<double>(result.spheres);
  if (p.warm_up_steps > 0)
    result.stages.push_back({"warm up", p.warm_up_steps * result.time_step, spheres, false});
  result.stages.push_back({"timed", p.timed_steps * result.time_step, spheres, false});
  return result;
}
} // namespace interlock::coupling
