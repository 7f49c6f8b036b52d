#include "dem/stones/edge_flips.h"

#include <algorithm>
#include <tuple>

namespace interlock::dem
{
namespace
{
struct Side {
  int low, high;       // ends of the edge
  int triangle, third; // the facet, and its corner that is not on the edge
  bool forward;        // the facet runs through the edge from low to high
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh)
{
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto& t = mesh.triangles[i];
      const int a = t[k], b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), int(i), t[(k + 2) % 3], a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, b.forward) < std::tie(b.low, b.high, a.forward);
  });
  return sides;
}

// Fair: seen from behind from the origin, and at least a third as high as an equilateral triangle
// of its longest side.
bool fair(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 normal = (b - a).cross(c - a);
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return normal.norm() > 0.3 * longest &&
         normal.dot(a + b + c) > 0.15 * normal.norm() * (a + b + c).norm();
}
} // namespace

void flip_edges(TriangleMesh& mesh, const std::function<double(const Vector3&)>& distance)
{
  constexpr int sweeps = 8;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::vector<Side> sides = sorted_sides(mesh);
    std::vector<bool> changed(mesh.triangles.size(), false);
    bool any = false;
    // The two sides of an edge follow each other, the forward one first.
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
      const Side &left = sides[i], &right = sides[i + 1];
      if (changed[left.triangle] || changed[right.triangle]) continue;
      const Vector3 &a = mesh.vertices[left.low], &b = mesh.vertices[left.high];
      const Vector3 &c = mesh.vertices[left.third], &d = mesh.vertices[right.third];
      const double now = distance((a + b) / 2), then = distance((c + d) / 2);
      if (then > 0.75 * now || now < 0.01 * (b - a).norm()) continue;
      if (!fair(a, d, c) || !fair(d, b, c)) continue;
      mesh.triangles[left.triangle] = {left.low, right.third, left.third};
      mesh.triangles[right.triangle] = {right.third, left.high, left.third};
      changed[left.triangle] = changed[right.triangle] = any = true;
    }
    if (!any) return;
  }
}
} // namespace interlock::dem
