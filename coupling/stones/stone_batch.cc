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
