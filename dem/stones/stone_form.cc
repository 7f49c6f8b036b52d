#include "dem/stones/stone_form.h"

#include "dem/meshes/mass_properties.h"
#include "dem/stones/angularity.h"
#include "dem/stones/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
StoneForm stone_form(const TriangleMesh& mesh)
{
  StoneForm form;
  form.size = stone_size(mesh);
  form.volume = mass_properties(mesh).volume;
  form.convexity = form.volume / convex_hull_volume(mesh.vertices);
  form.angularity = angularity_index(mesh);
  return form;
}

NodeSpacing node_spacing(const TriangleMesh& mesh)
{
  double count = 0, sum = 0, squares = 0;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const double length = (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm();
      ++count, sum += length, squares += length * length;
    }
  NodeSpacing spacing;
  if (count == 0) return spacing;
  spacing.mean = sum / count;
  spacing.variation =
      std::sqrt(std::max(0., squares / count - spacing.mean * spacing.mean)) / spacing.mean;
  return spacing;
}
} // namespace interlock::dem
