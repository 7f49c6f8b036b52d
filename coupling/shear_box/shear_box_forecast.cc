#include "coupling/shear_box/shear_box_forecast.h"

#include "coupling/shear_box/shear_box.h"
#include "coupling/stones/stone_batch.h"

#include <cmath>

namespace interlock::coupling
{
namespace
{
// Simulated times of what ends by itself, of the case [s].
constexpr double filling_time = 1, consolidating_time = 0.4;
} // namespace

Forecast forecast(const ShearBox& box)
{
  const ShearBoxParameters& p = box.parameters();
  const dem::Clumps& clumps = box.world().engine.clumps();
  Forecast result;
  result.stones = box.preparation();
  result.warnings = box.stone_warnings();
  result.clumps = expected_stones(clumps, box.area() * p.box.height);
  result.spheres = std::llround(mean_spheres(clumps) * static_cast<double>(result.clumps));
  result.time_step = box.world().clock.dt;
  result.frames = p.output.field_frames + 1;
  const double all = static_cast<double>(result.spheres);
  result.stages = {
      {FillStage::kind, filling_time, 0.5 * all, false},
      {ConsolidateStage::kind, consolidating_time, all, false},
      {ShearStage::kind, p.shear.distance / p.shear.speed + 0.5 * p.shear.ramp_time, all, false}};
  return result;
}
} // namespace interlock::coupling
