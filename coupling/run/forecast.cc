#include "coupling/run/forecast.h"

#include <cmath>
#include <numeric>

namespace interlock::coupling
{
std::int64_t Forecast::steps(const StageForecast& stage) const
{
  return time_step > 0 ? std::llround(stage.simulated_time / time_step) : 0;
}

double Forecast::time(const StageForecast& stage) const
{
  const double per_step = 1e-9 * stage.mean_spheres + (stage.has_flexible_ribs ? 28e-6 : 0);
  return static_cast<double>(steps(stage)) * per_step * slowness;
}

double Forecast::time() const
{
  return std::accumulate(stages.begin(), stages.end(), 0.,
                         [this](double sum, const StageForecast& s) { return sum + time(s); });
}

double Forecast::memory() const
{
  return program_memory + 2e3 * static_cast<double>(spheres);
}

double Forecast::frame_size() const
{
  return 42 * static_cast<double>(spheres);
}

double Forecast::disk() const
{
  constexpr double per_clump_and_state = 1.5e3;
  return frame_size() * frames + 4 * per_clump_and_state * static_cast<double>(clumps);
}
} // namespace interlock::coupling
