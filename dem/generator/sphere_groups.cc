#include "dem/generator/sphere_groups.h"

#include "dem/meshes/connected_parts.h"

namespace interlock::dem
{
bool spheres_touch(const Sphere& a, const Sphere& b)
{
  const double reach = (1 + 1e-9) * (a.radius + b.radius);
  return (a.centre - b.centre).squaredNorm() <= reach * reach;
}

int sphere_groups(const std::vector<Sphere>& spheres)
{
  const int count = static_cast<int>(spheres.size());
  ConnectedParts parts(spheres.size());
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j)
      if (spheres_touch(spheres[i], spheres[j])) parts.join(i, j);
  int groups = 0;
  for (int i = 0; i < count; ++i) groups += parts.part(i) == i;
  return groups;
}
} // namespace interlock::dem
