#include "coupling/pull_out/pull_out_forecast.h"

#include "coupling/pull_out/pull_out.h"
#include "coupling/stones/stone_batch.h"

#include <cmath>
#include <numeric>

namespace interlock::coupling
{
namespace
{
// Of the quick case: simulated times of what ends by itself: a filling (two or three pours that
// fall and come to rest), a flattening, a settling [s].
constexpr double filling_time = 1, flattening_time = 0.2, placing_time = 0.1, settling_time = 0.5;

// Simulated time of a stage.
struct Duration {
  const PullOutParameters& parameters;
  double operator()(const FillStage&) const { return filling_time; }
  double operator()(const FlattenStage&) const { return flattening_time; }
  double operator()(const PlaceStage&) const { return placing_time; }
  double operator()(const AdaptStage&) const { return 0; }
  double operator()(const LoadStage&) const { return settling_time; }
  double operator()(const SettleStage&) const { return settling_time; }
  double operator()(const PullStage&) const
  {
    const PullParameters& pull = parameters.pull;
    return pull.distance / pull.speed + 0.5 * pull.ramp_time;
  }
};
} // namespace

Forecast forecast(const PullOut& experiment)
{
  const PullOutParameters& p = experiment.parameters();
  const dem::Clumps& clumps = experiment.world().engine.clumps();
  const double volume = p.box.length * p.box.width * p.box.height;
  Forecast result;
  result.stones = experiment.preparation();
  result.warnings = experiment.stone_warnings();
  result.clumps = clumps.size() > 0 ? clumps.size() : expected_stones(clumps, volume);
  result.spheres = std::llround(mean_spheres(clumps) * static_cast<double>(result.clumps));
  result.time_step = experiment.world().clock.dt;
  result.frames = p.output.field_frames + 1;
  const double all = static_cast<double>(result.spheres);
  // Stones there are on average: from none to half, from half to all, all.
  double share = clumps.size() > 0 ? 1 : 0.25;
  bool placed = experiment.world().geogrid() != nullptr;
  for (const PullOut::Stage& stage : experiment.plan()) {
    if (std::holds_alternative<FillStage>(stage) && placed) share = 0.75;
    const std::string name = std::visit([](const auto& s) { return stage_name(s); }, stage);
    result.stages.push_back(
        {name, std::visit(Duration{p}, stage), share * all, placed && !p.geogrid.rigid});
    if (std::holds_alternative<FillStage>(stage)) share = placed ? 1 : 0.5;
    placed = placed || std::holds_alternative<PlaceStage>(stage);
  }
  return result;
}
} // namespace interlock::coupling
