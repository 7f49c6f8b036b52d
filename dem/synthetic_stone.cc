#include "dem/synthetic_stone.h"

#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/random_stream.h"
#include "dem/stone_size.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace interlock::dem
{
namespace
{
// A sphere cut into 20 f^2 nearly equal triangles: each face of the icosahedron is cut into f^2 and
// blown up. 10 f^2 + 2 nodes, unit radius, outward.
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

// An ellipsoid cut by planes, as a gauge: the point x is on the surface where gauge(x) = 1. The
// largest of the members' gauges would give sharp edges; their p-norm chamfers them, and the body
// stays convex. Broad shallow waves on top make faces uneven, as those of crushed rock are.
struct Fragment {
  struct Wave {
    Vector3 number; // radians per unit of the direction vector
    double phase;
  };
  Vector3 semi_axes;
  std::vector<Vector3> planes; // unit normal / distance from the origin
  std::vector<Wave> waves;
  static constexpr double amplitude = 0.002; // of one wave, relative

  // The p-norm with p = 2^doublings = 64, by repeated squaring: as exact as pow and far quicker.
  static constexpr int doublings = 6;
  static double raise(double x)
  {
    for (int k = 0; k < doublings; ++k) x *= x;
    return x;
  }

  // Where the ray along `direction` (unit vector) leaves the convex body.
  Vector3 surface_point(const Vector3& direction) const
  {
    double gauge = raise(direction.cwiseQuotient(semi_axes).norm());
    for (const Vector3& plane : planes) gauge += raise(std::max(0., plane.dot(direction)));
    for (int k = 0; k < doublings; ++k) gauge = std::sqrt(gauge);
    return direction / gauge;
  }

  double relief(const Vector3& direction) const
  {
    double sum = 1;
    for (const Wave& wave : waves)
      sum += amplitude * std::sin(wave.number.dot(direction) + wave.phase);
    return sum;
  }
};

// Ranges of elongation and flatness: most stones in published image analyses of railway ballast.
Fragment draw_fragment(RandomStream& random)
{
  Fragment fragment;
  const double elongation = random.uniform(0.6, 0.95), flatness = random.uniform(0.5, 0.95);
  fragment.semi_axes = Vector3(1, elongation, elongation * flatness);
  const int planes = 12 + random.index(14);
  std::vector<Vector3> normals;
  while (static_cast<int>(normals.size()) < planes) {
    const Vector3 normal = random.direction();
    // Planes at less than 27 degrees to one another would leave bare rounded caps elsewhere.
    if (std::any_of(normals.begin(), normals.end(),
                    [&](const Vector3& other) { return other.dot(normal) > 0.89; }))
      continue;
    normals.push_back(normal);
    // From where the plane would touch the ellipsoid, moved inwards.
    const double touching = normal.cwiseProduct(fragment.semi_axes).norm();
    fragment.planes.push_back(normal / (touching * random.uniform(0.60, 0.85)));
  }
  for (int k = 0; k < 6; ++k) {
    const double number = random.uniform(4, 12);
    const Vector3 direction = random.direction();
    fragment.waves.push_back({number * direction, random.uniform(0, 2 * M_PI)});
  }
  return fragment;
}

// Wraps a sphere's mesh around the fragment, stretched along the axes, with its nodes spread
// evenly: each moves to the mean of its facets and then back along its ray onto the surface. Rays
// through the origin meet a convex body once, so facets keep their orientation.
void wrap(TriangleMesh& mesh, const Fragment& fragment, const Vector3& stretch)
{
  const auto count = mesh.vertices.size();
  const auto direction = [&](const Vector3& x) {
    return Vector3(x.cwiseQuotient(stretch).normalized());
  };
  const auto onto_surface = [&](const Vector3& x) {
    return Vector3(fragment.surface_point(direction(x)).cwiseProduct(stretch));
  };
  for (Vector3& x : mesh.vertices) x = onto_surface(x);
  for (int sweep = 0; sweep < 60; ++sweep) {
    std::vector<Vector3> sum(count, Vector3::Zero());
    std::vector<double> weight(count, 0);
    for (const auto& t : mesh.triangles) {
      const Vector3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      const Vector3 centroid = (a + b + c) / 3;
      // Large facets pull, so that they shrink.
      const double area = (b - a).cross(c - a).norm();
      for (const int v : t) sum[v] += area * centroid, weight[v] += area;
    }
    for (std::size_t v = 0; v < count; ++v) mesh.vertices[v] = onto_surface(sum[v] / weight[v]);
  }
  for (Vector3& x : mesh.vertices) x *= fragment.relief(direction(x));
}

void centre(TriangleMesh& mesh)
{
  const Vector3 centre = mass_properties(mesh).centre;
  for (Vector3& x : mesh.vertices) x -= centre;
}

TriangleMesh make_stone(double size, std::uint64_t seed)
{
  RandomStream random(seed);
  const Fragment fragment = draw_fragment(random);
  // Cutting shortens the axes unevenly; stretching brings the drawn proportions back.
  TriangleMesh probe = geodesic_sphere(8);
  for (Vector3& x : probe.vertices) x = fragment.surface_point(x);
  const Vector3 stretch = fragment.semi_axes.cwiseQuotient(extents(probe) / 2);
  wrap(probe, fragment, stretch);
  const double scale = size / stone_size(probe).sieve;

  // 10 f^2 nodes, one per 2.2 mm2, within what the clump generator needs and a DEM can afford.
  const double area = scale * scale * surface_area(probe);
  const int f = std::clamp(int(std::lround(std::sqrt(area / 2.2e-6 / 10))), 12, 17);
  TriangleMesh mesh = geodesic_sphere(f);
  wrap(mesh, fragment, stretch);
  const double exact_scale = size / stone_size(mesh).sieve;
  for (Vector3& x : mesh.vertices) x *= exact_scale;
  centre(mesh);
  return mesh;
}
} // namespace

std::vector<double> ballast_sizes(int count)
{
  struct Class {
    double low, high, mass_share;
  };
  // Table 5. Stones far below 18 mm would be many and weigh nothing.
  constexpr std::array<Class, 5> classes{
      {{18, 22, 1}, {22, 32, 18}, {32, 40, 44}, {40, 50, 32}, {50, 63, 5}}};
  // Mass is spread evenly over the sizes of a class, so the number density is share/width / d^3,
  // and its integral from `low` to d is share/width (1/low^2 - 1/d^2)/2.
  const auto number = [](const Class& c, double d) {
    return c.mass_share / (c.high - c.low) * (1 / (c.low * c.low) - 1 / (d * d)) / 2;
  };
  double total = 0;
  for (const Class& c : classes) total += number(c, c.high);

  std::vector<double> sizes;
  for (int i = 0; i < count; ++i) {
    double rest = (i + 0.5) / count * total;
    auto c = classes.begin();
    for (; c + 1 != classes.end() && rest > number(*c, c->high); ++c) rest -= number(*c, c->high);
    const double inverse_square =
        1 / (c->low * c->low) - 2 * rest * (c->high - c->low) / c->mass_share;
    sizes.push_back(1e-3 / std::sqrt(inverse_square));
  }
  return sizes;
}

std::vector<TriangleMesh> make_stones(int count, std::uint64_t seed)
{
  if (count < 1)
    throw InputError("The number of stones is " + std::to_string(count) +
                     ", but must be at least 1.");
  RandomStream random(seed);
  const std::vector<double> sizes = ballast_sizes(count);
  std::vector<TriangleMesh> stones;
  for (const int i : random.permutation(count))
    stones.push_back(make_stone(sizes[i], seed * 0x9E3779B97F4A7C15u + stones.size()));
  return stones;
}
} // namespace interlock::dem
