#include "dem/meshes/triangle_mesh.h"

#include "dem/meshes/connected_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interlock::dem
{
namespace
{
// One facet runs through the edge between `low` and `high`, upwards or downwards.
struct EdgeUse {
  int high;
  bool upwards;
};

// The uses of all edges, sorted into buckets by the lower vertex: uses[start[low]] to
// uses[start[low + 1] - 1]. A sort of all of them at once takes four times as long.
struct EdgeUses {
  std::vector<int> start;
  std::vector<EdgeUse> uses;
};

EdgeUses edge_uses(const TriangleMesh& mesh)
{
  EdgeUses result;
  result.start.assign(mesh.vertices.size() + 1, 0);
  const auto for_each_edge = [&](auto&& action) {
    for (const auto& triangle : mesh.triangles)
      for (int k = 0; k < 3; ++k) action(triangle[k], triangle[(k + 1) % 3]);
  };
  for_each_edge([&](int from, int to) { ++result.start[std::min(from, to) + 1]; });
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.uses.resize(3 * mesh.triangles.size());
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  for_each_edge([&](int from, int to) {
    result.uses[next[std::min(from, to)]++] = {std::max(from, to), from < to};
  });
  return result;
}

// Rims that share a vertex count as one hole.
int count_holes(const std::vector<std::array<int, 2>>& open_edges, std::size_t vertices)
{
  if (open_edges.empty()) return 0;
  ConnectedParts rims(vertices);
  for (const auto& edge : open_edges) rims.join(edge[0], edge[1]);
  std::vector<int> parts;
  for (const auto& edge : open_edges) parts.push_back(rims.part(edge[0]));
  std::sort(parts.begin(), parts.end());
  return static_cast<int>(std::unique(parts.begin(), parts.end()) - parts.begin());
}
} // namespace

EdgeDiagnosis diagnose_edges(const TriangleMesh& mesh)
{
  // Each facet runs through its edges once; a sound edge is run through once in either direction.
  EdgeDiagnosis diagnosis;
  std::vector<std::array<int, 2>> open_edges;
  EdgeUses edges = edge_uses(mesh);
  const auto is_lower = [](const EdgeUse& a, const EdgeUse& b) { return a.high < b.high; };
  for (std::size_t low = 0; low < mesh.vertices.size(); ++low) {
    const auto end = edges.uses.begin() + edges.start[low + 1];
    auto first = edges.uses.begin() + edges.start[low];
    std::sort(first, end, is_lower);
    while (first != end) {
      auto last = first;
      while (last != end && last->high == first->high) ++last;
      if (last - first == 1)
        open_edges.push_back({static_cast<int>(low), first->high});
      else if (last - first > 2)
        ++diagnosis.branching;
      else if (first->upwards == (first + 1)->upwards)
        ++diagnosis.flipped;
      first = last;
    }
  }
  diagnosis.open = static_cast<int>(open_edges.size());
  diagnosis.holes = count_holes(open_edges, mesh.vertices.size());
  return diagnosis;
}

int count_open_edges(const TriangleMesh& mesh)
{
  const EdgeDiagnosis diagnosis = diagnose_edges(mesh);
  return diagnosis.open + diagnosis.flipped + diagnosis.branching;
}

Vector3 extents(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  return box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.sizes());
}

namespace
{
double facet_area(const TriangleMesh& mesh, const std::array<int, 3>& triangle)
{
  const Vector3& a = mesh.vertices[triangle[0]];
  const Vector3 ab = mesh.vertices[triangle[1]] - a, ac = mesh.vertices[triangle[2]] - a;
  return ab.cross(ac).norm() / 2;
}
} // namespace

double surface_area(const TriangleMesh& mesh)
{
  double area = 0;
  for (const auto& triangle : mesh.triangles) area += facet_area(mesh, triangle);
  return area;
}

std::vector<double> node_areas(const TriangleMesh& mesh)
{
  std::vector<double> areas(mesh.vertices.size(), 0.);
  for (const auto& triangle : mesh.triangles)
    for (const int node : triangle) areas[node] += facet_area(mesh, triangle) / 3;
  return areas;
}

std::vector<Vector3> node_normals(const TriangleMesh& mesh)
{
  std::vector<Vector3> normals(mesh.vertices.size(), Vector3::Zero());
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vector3& corner = mesh.vertices[triangle[k]];
      const Vector3 to_next = mesh.vertices[triangle[(k + 1) % 3]] - corner;
      const Vector3 to_last = mesh.vertices[triangle[(k + 2) % 3]] - corner;
      const Vector3 cross = to_next.cross(to_last);
      const double twice_area = cross.norm();
      // A sliver whose corners lie on one line has no normal; its neighbours give the direction.
      if (twice_area == 0) continue;
      normals[triangle[k]] += std::atan2(twice_area, to_next.dot(to_last)) / twice_area * cross;
    }
  for (Vector3& normal : normals) {
    const double length = normal.norm();
    normal = length > 1e-9 ? Vector3(normal / length) : Vector3(Vector3::Zero());
  }
  return normals;
}
} // namespace interlock::dem
