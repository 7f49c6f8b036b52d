#include "dem/stones/geodesic_sphere.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace interlock::dem
{
TriangleMesh geodesic_sphere(int f)
{
  const double t = (1 + std::sqrt(5.)) / 2;
  const std::array<Vector3, 12> corners{{{-1, t, 0},
                                         {1, t, 0},
                                         {-1, -t, 0},
                                         {1, -t, 0},
                                         {0, -1, t},
                                         {0, 1, t},
                                         {0, -1, -t},
                                         {0, 1, -t},
                                         {t, 0, -1},
                                         {t, 0, 1},
                                         {-t, 0, -1},
                                         {-t, 0, 1}}};
  constexpr std::array<std::array<int, 3>, 20> faces{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  TriangleMesh mesh;
  // A node on an edge is found from both sides by its weights on the corners of the icosahedron.
  std::map<std::array<int, 12>, int> known;
  for (const auto& face : faces) {
    const auto node = [&](int i, int j) {
      std::array<int, 12> weights{};
      weights[face[0]] = f - i - j, weights[face[1]] = i, weights[face[2]] = j;
      const auto [entry, is_new] = known.try_emplace(weights, int(mesh.vertices.size()));
      if (is_new) {
        Vector3 sum = Vector3::Zero();
        for (int c = 0; c < 12; ++c) sum += weights[c] * corners[c];
        mesh.vertices.push_back(sum.normalized());
      }
      return entry->second;
    };
    for (int i = 0; i < f; ++i)
      for (int j = 0; i + j < f; ++j) {
        mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
        if (i + j < f - 1)
          mesh.triangles.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
      }
  }
  return mesh;
}

TriangleMesh quartered(const TriangleMesh& mesh)
{
  TriangleMesh fine;
  fine.vertices = mesh.vertices;
  std::map<std::array<int, 2>, int> known;
  const auto middle = [&](int a, int b) {
    const auto [entry, is_new] =
        known.try_emplace({std::min(a, b), std::max(a, b)}, int(fine.vertices.size()));
    if (is_new) fine.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return entry->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}
} // namespace interlock::dem
