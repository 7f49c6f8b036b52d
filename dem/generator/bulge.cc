#include "dem/generator/bulge.h"

#include "dem/generator/union_volume.h"

namespace interlock::dem
{
std::vector<Sphere> bulged(std::vector<Sphere> spheres, double bulge)
{
  for (Sphere& sphere : spheres) sphere.radius += bulge;
  return spheres;
}

double bulge_for_volume(const std::vector<Sphere>& spheres, double volume, double largest)
{
  const auto is_enough = [&](double bulge) {
    return UnionVolume(bulged(spheres, bulge)).volume() >= volume;
  };
  if (largest <= 0 || is_enough(0)) return 0;
  if (!is_enough(largest)) return largest;
  double low = 0, high = largest;
  for (int halvings = 0; halvings < 20; ++halvings) {
    const double middle = (low + high) / 2;
    (is_enough(middle) ? high : low) = middle;
  }
  return high;
}
} // namespace interlock::dem
