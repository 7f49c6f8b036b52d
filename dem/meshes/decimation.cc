#include "dem/meshes/decimation.h"

#include <meshoptimizer.h>

namespace interlock::dem
{
namespace
{
// The same triangles without the nodes that none of them has.
TriangleMesh compact(const TriangleMesh& mesh, const std::vector<unsigned>& corners)
{
  TriangleMesh result;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    int& n = number[corners[k]];
    if (n < 0) {
      n = static_cast<int>(result.vertices.size());
      result.vertices.push_back(mesh.vertices[corners[k]]);
    }
    if (k % 3 == 0) result.triangles.emplace_back();
    result.triangles.back()[k % 3] = n;
  }
  return result;
}
// May fold a part of the surface onto itself.
TriangleMesh simplified(const TriangleMesh& mesh, const std::vector<float>& places,
                        const std::vector<unsigned>& corners, int triangles)
{
  constexpr float farthest = 0.05; // of the largest extent
  std::vector<unsigned> fewer(corners.size());
  fewer.resize(meshopt_simplify(fewer.data(), corners.data(), corners.size(), places.data(),
                                mesh.vertices.size(), 3 * sizeof(float), 3 * triangles, farthest, 0,
                                nullptr));
  return compact(mesh, fewer);
}
} // namespace

TriangleMesh decimated(const TriangleMesh& mesh, int triangles)
{
  std::vector<float> places;
  for (const Vector3& x : mesh.vertices)
    for (int c = 0; c < 3; ++c) places.push_back(static_cast<float>(x[c]));
  std::vector<unsigned> corners;
  for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  const int all = static_cast<int>(mesh.triangles.size());
  for (int wanted = triangles; wanted < all; wanted += wanted / 10 + 2) {
    const TriangleMesh coarse = simplified(mesh, places, corners, wanted);
    if (count_open_edges(coarse) == 0) return coarse;
  }
  return mesh;
}
} // namespace interlock::dem
