#include "dem/generator/octahedron_tables.h"

#include "dem/generator/clump_generator.h"
#include "dem/random_stream.h"

#include <cmath>
#include <map>

namespace interlock::dem
{
namespace
{
// Moves a node of the face or edge with these corners of the octahedron and weights on them.
Vector3 shift(const std::map<int, int>& weights, const std::array<Vector3, 6>& corners,
              RandomStream& random)
{
  constexpr double share = 0.1; // of the node spacing
  const Vector3& a = corners[weights.begin()->first];
  const Vector3 along = (corners[std::next(weights.begin())->first] - a) / octahedron_divisions;
  Vector3 result = random.uniform(-share, share) * along;
  if (weights.size() == 3) {
    const Vector3 other = corners[weights.rbegin()->first] - a;
    const Vector3 across = other - other.dot(along) / along.squaredNorm() * along;
    result += random.uniform(-share, share) * along.norm() * across.normalized();
  }
  return result;
}
} // namespace

TriangleMesh irregular_octahedron(std::uint64_t seed)
{
  constexpr int n = octahedron_divisions;
  const double c = octahedron_edge / std::sqrt(2.);
  const std::array<Vector3, 6> corners{
      {{c, 0, 0}, {-c, 0, 0}, {0, c, 0}, {0, -c, 0}, {0, 0, c}, {0, 0, -c}}};
  constexpr std::array<std::array<int, 3>, 8> faces{
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  RandomStream random(seed);
  TriangleMesh mesh;
  // A node on an edge is found from both faces by its weights on the corners.
  std::map<std::map<int, int>, int> known;
  for (const auto& face : faces) {
    const auto node = [&](int i, int j) {
      std::map<int, int> weights;
      const int share[] = {n - i - j, i, j};
      for (int k = 0; k < 3; ++k)
        if (share[k] > 0) weights[face[k]] = share[k];
      const auto [entry, is_new] = known.try_emplace(weights, int(mesh.vertices.size()));
      if (is_new) {
        Vector3 x = Vector3::Zero();
        for (const auto& [corner, weight] : weights) x += double(weight) / n * corners[corner];
        if (weights.size() > 1) x += shift(weights, corners, random);
        mesh.vertices.push_back(x);
      }
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

std::vector<OctahedronTable> published_octahedron_tables()
{
  return {{"Table 1: distance d_min",
           {{0, 2, 100, 2312},
            {0.1, 2, 100, 952},
            {0.2, 2, 100, 546},
            {0.3, 2, 100, 332},
            {0.5, 2, 100, 188},
            {1, 2, 100, 87}}},
          {"Table 2: smallest radius r_min",
           {{0.1, 0, 100, 1439},
            {0.1, 2, 100, 952},
            {0.1, 4, 100, 702},
            {0.1, 5, 100, 485},
            {0.1, 7, 100, 264},
            {0.1, 9, 100, 125}}},
          {"Table 3: share of the nodes p_max",
           {{0.1, 2, 3, 73},
            {0.1, 2, 5, 123},
            {0.1, 2, 10, 239},
            {0.1, 2, 20, 460},
            {0.1, 2, 30, 668},
            {0.1, 2, 100, 952}}}};
}

double mean_sphere_count(const OctahedronCell& cell, int seeds)
{
  double sum = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    ClumpParameters parameters;
    parameters.d_min = 1e-3 * cell.d_min;
    parameters.r_min = 1e-3 * cell.r_min;
    parameters.p_max = cell.p_max;
    parameters.touching_radius = TouchingRadius::nodes;
    parameters.seed = seed;
    sum += make_clump(irregular_octahedron(seed), parameters).spheres.size();
  }
  return sum / seeds;
}
} // namespace interlock::dem
