#include "dem/triangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
EdgeDiagnosis diagnose_edges(const TriangleMesh& mesh)
{
  // Each facet runs through its edges once; a sound edge is run through once in either direction.
  struct Use {
    int low, high, direction;
    bool operator<(const Use& other) const
    {
      return low != other.low ? low < other.low : high < other.high;
    }
  };
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  std::sort(uses.begin(), uses.end());

  EdgeDiagnosis diagnosis;
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::upper_bound(first, uses.end(), *first);
    const auto facets = last - first;
    if (facets == 1)
      ++diagnosis.open;
    else if (facets > 2)
      ++diagnosis.branching;
    else if (first->direction == (first + 1)->direction)
      ++diagnosis.flipped;
    first = last;
  }
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

double surface_area(const TriangleMesh& mesh)
{
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector3& a = mesh.vertices[triangle[0]];
    const Vector3 ab = mesh.vertices[triangle[1]] - a, ac = mesh.vertices[triangle[2]] - a;
    area += ab.cross(ac).norm() / 2;
  }
  return area;
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
