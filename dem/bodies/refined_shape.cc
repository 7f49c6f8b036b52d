#include "dem/bodies/refined_shape.h"

#include "dem/input_error.h"

#include <string>

namespace interlock::dem
{
namespace
{
bool covered_by_another(const std::vector<Sphere>& spheres, int own, const Vector3& point)
{
  for (int k = 0; k < static_cast<int>(spheres.size()); ++k)
    if (k != own && (point - spheres[k].centre).norm() < spheres[k].radius) return true;
  return false;
}
} // namespace

ClumpShape refined_shape(const ClumpShape& shape, int n_spheres, const RadiusRange& range,
                         RandomStream& random)
{
  const std::vector<Sphere>& given = shape.spheres;
  const int n_given = static_cast<int>(given.size());
  if (n_given > n_spheres)
    throw InputError("The clump " + shape.name + " has " + std::to_string(n_given) +
                     " spheres and cannot be refined to " + std::to_string(n_spheres) +
                     "; give that many or more.");
  ClumpShape result = shape;
  // Where a sphere is nearly covered by others, few attempts find the rest of its surface.
  const std::int64_t most_attempts = 1000 + std::int64_t{1000} * n_spheres;
  for (std::int64_t attempt = 0; attempt < most_attempts; ++attempt) {
    if (static_cast<int>(result.spheres.size()) == n_spheres) return result;
    const int m = random.index(n_given);
    const Vector3 direction = random.direction();
    const double radius = random.uniform(range.smallest, range.largest);
    const Sphere& outer = given[m];
    if (radius > outer.radius) continue;
    if (covered_by_another(given, m, outer.centre + outer.radius * direction)) continue;
    result.spheres.push_back({outer.centre + (outer.radius - radius) * direction, radius});
  }
  throw InputError("The clump " + shape.name + " has no place for spheres with radii from " +
                   std::to_string(1e3 * range.smallest) + " to " +
                   std::to_string(1e3 * range.largest) + " mm inside its surface.");
}
} // namespace interlock::dem
