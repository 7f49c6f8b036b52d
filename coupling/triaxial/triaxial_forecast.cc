#include "coupling/triaxial/triaxial_forecast.h"

#include "coupling/stones/stone_batch.h"
#include "coupling/triaxial/triaxial.h"

#include <cmath>

namespace interlock::coupling
{
namespace
{
// Simulated times of what ends by itself, of the case [s].
constexpr double filling_time = 1, consolidating_time = 0.6;
} // namespace

Forecast forecast(const Triaxial& test)
{
  const TriaxialParameters& p = test.parameters();
  const dem::Clumps& clumps = test.world().engine.clumps();
  Forecast result;
  result.stones = test.preparation();
  result.warnings = test.stone_warnings();
  result.clumps = expected_stones(clumps, p.box.length * p.box.width * p.box.height);
  result.spheres = std::llround(mean_spheres(clumps) * static_cast<double>(result.clumps));
  result.time_step = test.world().clock.dt;
  result.frames = p.output.field_frames + 1;
  const double all = static_cast<double>(result.spheres);
  const double compressing_time =
      p.compression.strain / p.compression.strain_rate + 0.5 * p.compression.ramp_time;
  result.stages = {{FillStage::kind, filling_time, 0.5 * all, false},
                   {IsotropicStage::kind, consolidating_time, all, false},
                   {CompressStage::kind, compressing_time, all, false}};
  return result;
}
} // namespace interlock::coupling
