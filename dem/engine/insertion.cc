#include "dem/engine/insertion.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
bool nearer(const Vector3& a, const Vector3& b, double distance)
{
  return distance > 0 && (a - b).squaredNorm() < distance * distance;
}

// Member spheres in the world.
std::vector<Sphere> placed(const ClumpShape& shape, const Vector3& position,
                           const Quaternion& orientation)
{
  std::vector<Sphere> spheres;
  for (const Sphere& s : shape.spheres)
    spheres.push_back({position + orientation * s.centre, s.radius});
  return spheres;
}

bool overlaps_clump(const Clumps& clumps, int i, const std::vector<Sphere>& spheres,
                    double clearance)
{
  for (const Sphere& s : spheres) {
    if (!nearer(s.centre, clumps.position[i], s.radius + clumps.bounding_radius(i) + clearance))
      continue;
    const std::vector<Sphere>& others = clumps.shape_of(i).spheres;
    for (std::size_t b = 0; b < others.size(); ++b)
      if (nearer(s.centre, clumps.position[i] + clumps.member_offset(i, static_cast<int>(b)),
                 s.radius + others[b].radius + clearance))
        return true;
  }
  return false;
}
} // namespace

bool place_is_free(const Clumps& clumps, const std::vector<Wall>& walls, const ClumpShape& shape,
                   const Vector3& position, const Quaternion& orientation, double clearance)
{
  const double radius = shape.bounding_radius();
  const std::vector<Sphere> spheres = placed(shape, position, orientation);
  for (const Wall& wall : walls)
    if (std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& s) {
          return nearer(s.centre, wall.nearest_point(s.centre), s.radius + clearance);
        }))
      return false;
  for (int i = 0; i < clumps.size(); ++i)
    if (nearer(position, clumps.position[i], radius + clumps.bounding_radius(i) + clearance) &&
        overlaps_clump(clumps, i, spheres, clearance))
      return false;
  return true;
}
} // namespace interlock::dem
