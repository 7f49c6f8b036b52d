#include "dem/scans/touching_corners.h"

#include <algorithm>
#include <numeric>

namespace interlock::dem
{
namespace
{
// A facet at a corner: counter-clockwise, the corner is followed by `next` and then by `last`.
struct Leaf {
  int next, last, facet, place; // place: of the corner in the facet
};

// The leaves of each vertex: leaves[start[v]] to leaves[start[v + 1] - 1], in the order of the
// facets.
struct Leaves {
  std::vector<int> start;
  std::vector<Leaf> leaves;
};

Leaves leaves_of(const TriangleMesh& mesh)
{
  Leaves result;
  result.start.assign(mesh.vertices.size() + 1, 0);
  for (const auto& t : mesh.triangles)
    for (const int v : t) ++result.start[v + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.leaves.resize(3 * mesh.triangles.size());
  std::vector<int> free(result.start.begin(), result.start.end() - 1);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto& t = mesh.triangles[f];
      result.leaves[free[t[k]]++] = {t[(k + 1) % 3], t[(k + 2) % 3], static_cast<int>(f), k};
    }
  return result;
}

// The fan of each leaf, from 0; empty where the leaves are no closed fans.
std::vector<int> fans_of(const Leaf* leaves, int count)
{
  std::vector<int> by_next(count);
  std::iota(by_next.begin(), by_next.end(), 0);
  std::sort(by_next.begin(), by_next.end(),
            [&](int a, int b) { return leaves[a].next < leaves[b].next; });
  for (int k = 1; k < count; ++k)
    if (leaves[by_next[k]].next == leaves[by_next[k - 1]].next) return {};
  std::vector<int> fans(count, -1);
  int fan = 0;
  for (int first = 0; first < count; ++first) {
    if (fans[first] >= 0) continue;
    int leaf = first;
    do {
      fans[leaf] = fan;
      const auto found =
          std::lower_bound(by_next.begin(), by_next.end(), leaves[leaf].last,
                           [&](int a, int wanted) { return leaves[a].next < wanted; });
      if (found == by_next.end() || leaves[*found].next != leaves[leaf].last) return {};
      leaf = *found;
    } while (fans[leaf] < 0);
    if (leaf != first) return {};
    ++fan;
  }
  return fans;
}
} // namespace

std::vector<std::array<int, 2>> part_touching_corners(TriangleMesh& mesh)
{
  std::vector<std::array<int, 2>> parted;
  const Leaves all = leaves_of(mesh);
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (int v = 0; v < vertices; ++v) {
    const Leaf* leaves = all.leaves.data() + all.start[v];
    const int count = all.start[v + 1] - all.start[v];
    if (count < 4) continue; // a closed fan has two facets at least
    const std::vector<int> fans = fans_of(leaves, count);
    if (fans.empty()) continue;
    const int first_new = static_cast<int>(mesh.vertices.size()) - 1; // plus the fan, from 1
    const int last_fan = *std::max_element(fans.begin(), fans.end());
    for (int fan = 1; fan <= last_fan; ++fan) {
      parted.push_back({v, static_cast<int>(mesh.vertices.size())});
      const Vector3 place = mesh.vertices[v];
      mesh.vertices.push_back(place);
    }
    for (int k = 0; k < count; ++k)
      if (fans[k] > 0) mesh.triangles[leaves[k].facet][leaves[k].place] = first_new + fans[k];
  }
  return parted;
}
} // namespace interlock::dem
