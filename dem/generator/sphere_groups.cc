#include "dem/generator/sphere_groups.h"

#include "dem/meshes/connected_parts.h"

namespace interlock::dem
{
int sphere_groups(const std::vector<Sphere>& spheres)
{
  const int count = static_cast<int>(spheres.size());
  ConnectedParts parts(spheres.size());
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j) {
      const double reach = (1 + 1e-9) * (spheres[i].radius + spheres[j].radius);
      if ((spheres[i].centre - spheres[j].centre).squaredNorm() <= reach * reach) parts.join(i, j);
    }
  int groups = 0;
  for (int i = 0; i < count; ++i) groups += parts.part(i) == i;
  return groups;
}
} // namespace interlock::dem
