#include "coupling/stones/stone_batch.h"

#include "coupling/stones/pouring.h"
#include "coupling/stones/stone_quality.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
StoneBatch add_shapes(const std::vector<Stone>& stones, dem::Clumps& clumps)
{
  StoneBatch batch;
  batch.shapes = static_cast<int>(stones.size());
  double volume = 0;
  std::size_t spheres = 0;
  for (const Stone& stone : stones) {
    const dem::ClumpShape& shape = stone.shape;
    volume += shape.volume;
    spheres += shape.spheres.size();
    for (const dem::Sphere& sphere : shape.spheres) batch.mean_sphere_radius += sphere.radius;
    clumps.add_shape(shape);
  }
  batch.mean_sphere_radius /= static_cast<double>(spheres);
  batch.mean_size = std::cbrt(6 / M_PI * volume / batch.shapes);
  batch.text =
      fmt::format("{} stones of {} spheres on average, {}, mean size {:.1f} mm", batch.shapes,
                  spheres / batch.shapes, quality_text(stones), 1e3 * batch.mean_size);
  batch.warnings = quality_warnings(stones);
  return batch;
}

StoneBatch add_shapes(const std::vector<Stone>& stones, double density, const TimeParameters& time,
                      World& world)
{
  StoneBatch batch = add_shapes(stones, world.engine.clumps());
  const dem::StableStep stable = world.engine.expected_stable_step(
      std::vector<double>(batch.shapes, density), expected_contacts);
  const double given = choose_time_step(time, stable);
  world.step_rule = step_rule(time, stable);
  world.clock.set_step(time.step > 0 ? given : world.step_rule.step({}));
  batch.text += "; " + time_step_budget(world.clock.dt, stable);
  return batch;
}

double mean_spheres(const dem::Clumps& clumps)
{
  std::size_t spheres = 0;
  for (const dem::ClumpShape& shape : clumps.shapes()) spheres += shape.spheres.size();
  return static_cast<double>(spheres) / static_cast<double>(clumps.shapes().size());
}

std::int64_t expected_stones(const dem::Clumps& clumps, double volume)
{
  // Share of a box that stones fill in the end; of the quick pull-out [-].
  constexpr double solid_share = 0.55;
  double mean_volume = 0;
  for (const dem::ClumpShape& shape : clumps.shapes()) mean_volume += shape.volume;
  mean_volume /= static_cast<double>(clumps.shapes().size());
  return std::llround(solid_share * volume / mean_volume);
}

void check_stones_fit(const std::vector<Stone>& stones, const BoxParameters& box)
{
  const double room = std::min(box.length, box.width) - 2 * pouring_clearance;
  for (const Stone& stone : stones) {
    const double size = 2 * stone.shape.bounding_radius();
    if (size > room)
      throw InputError(fmt::format("Stone {} is {:.3g} m across, but the box is only {:.3g} m {}.",
                                   stone.shape.name, size, std::min(box.length, box.width),
                                   box.length < box.width ? "long" : "wide"));
  }
}
} // namespace interlock::coupling
