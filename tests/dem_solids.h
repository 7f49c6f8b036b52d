// Closed meshes of solids with known closed forms, for the tests of the clump shapes.
#pragma once

#include "dem/meshes/triangle_mesh.h"

#include <algorithm>
#include <map>

namespace solids
{
using interlock::dem::TriangleMesh;
using interlock::dem::Vector3;

// Cuts each facet of `base` into n^2 equal ones; nodes on shared edges are shared.
inline TriangleMesh subdivide(const TriangleMesh& base, int n)
{
  using Key = std::map<int, int>; // corner of the base -> weight; weights sum to n
  TriangleMesh mesh;
  std::map<Key, int> known;
  for (const auto& t : base.triangles) {
    const auto node = [&](int i, int j) {
      Key key;
      if (n - i - j > 0) key[t[0]] = n - i - j;
      if (i > 0) key[t[1]] = i;
      if (j > 0) key[t[2]] = j;
      const auto [entry, is_new] = known.try_emplace(key, int(mesh.vertices.size()));
      if (!is_new) return entry->second;
      Vector3 x = Vector3::Zero();
      for (const auto& [corner, weight] : key) x += double(weight) / n * base.vertices[corner];
      mesh.vertices.push_back(x);
      return entry->second;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
        if (i + j < n - 1)
          mesh.triangles.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
      }
  }
  return mesh;
}

// Around the origin, sides along x, y, z.
inline TriangleMesh box(double a, double b, double c)
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({(i & 1 ? a : -a) / 2, (i & 2 ? b : -b) / 2, (i & 4 ? c : -c) / 2});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// Regular, around the origin, corners on the axes, all edges of length a.
inline TriangleMesh octahedron(double a)
{
  const double c = a / std::sqrt(2.);
  TriangleMesh mesh;
  mesh.vertices = {{c, 0, 0}, {-c, 0, 0}, {0, c, 0}, {0, -c, 0}, {0, 0, c}, {0, 0, -c}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

// Corners at the origin and at a, b, c on the axes.
inline TriangleMesh corner_tetrahedron(double a, double b, double c)
{
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const interlock::dem::Matrix3& rotation,
                          const Vector3& shift)
{
  for (Vector3& x : mesh.vertices) x = rotation * x + shift;
  return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh)
{
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}
} // namespace solids
