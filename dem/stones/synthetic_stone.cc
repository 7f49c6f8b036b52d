#include "dem/stones/synthetic_stone.h"

#include "dem/input_error.h"
#include "dem/meshes/mass_properties.h"
#include "dem/stones/ballast_sizes.h"
#include "dem/stones/edge_flips.h"
#include "dem/stones/fragment.h"
#include "dem/stones/geodesic_sphere.h"
#include "dem/stones/roughness.h"
#include "dem/stones/stone_size.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
// A fragment stretched along the axes.
struct Form {
  Fragment fragment;
  Vector3 stretch = Vector3::Ones();

  // The point of the surface on the ray through x.
  Vector3 project(const Vector3& x) const { return x / fragment.gauge(x.cwiseQuotient(stretch)); }
};

// Spreads the nodes evenly: each moves to the mean of its facets, of which large ones pull more so
// that they shrink, and then back along its ray onto the surface.
void relax(TriangleMesh& mesh, const Form& form, int sweeps)
{
  const auto count = mesh.vertices.size();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<Vector3> sum(count, Vector3::Zero());
    std::vector<double> weight(count, 0);
    for (const auto& t : mesh.triangles) {
      const Vector3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      const Vector3 centroid = (a + b + c) / 3;
      const double area = (b - a).cross(c - a).norm();
      for (const int v : t) sum[v] += area * centroid, weight[v] += area;
    }
    for (std::size_t v = 0; v < count; ++v) mesh.vertices[v] = form.project(sum[v] / weight[v]);
  }
}

// About 10 f^2 nodes. Spreading goes by one node a sweep, so fine meshes start from coarse ones.
TriangleMesh wrap(const Form& form, int f)
{
  int halvings = 0;
  while (f >> halvings > 17) ++halvings;
  TriangleMesh mesh = geodesic_sphere(int(std::lround(std::ldexp(f, -halvings))));
  for (Vector3& x : mesh.vertices) x = form.project(x.cwiseProduct(form.stretch));
  relax(mesh, form, 80);
  for (; halvings > 0; --halvings) {
    mesh = quartered(mesh);
    relax(mesh, form, 20);
  }
  flip_edges(mesh, [&](const Vector3& x) { return (x - form.project(x)).norm(); });
  return mesh;
}

// Number of cuts of an edge of the icosahedron that gives the spacing: one node has an area of
// sqrt(3)/2 spacing^2.
int fineness(double area, double spacing)
{
  const auto wanted = [area](double h) {
    return int(std::lround(std::sqrt(area / (std::sqrt(3.) / 2 * h * h) / 10)));
  };
  // By default within what the clump generator needs and a DEM can afford.
  return spacing > 0 ? std::max(4, wanted(spacing)) : std::clamp(wanted(0.0016), 13, 16);
}

TriangleMesh make_stone(double size, std::uint64_t seed, const StoneStyle& style)
{
  RandomStream random(seed);
  Form form{Fragment(style, random)};
  // Cutting shortens the axes unevenly; stretching brings the drawn proportions back.
  TriangleMesh probe = geodesic_sphere(12);
  for (Vector3& x : probe.vertices) x = form.project(x);
  form.stretch = form.fragment.semi_axes().cwiseQuotient(extents(probe) / 2);
  probe = wrap(form, 12);
  const double scale = size / stone_size(probe).sieve;

  TriangleMesh mesh = wrap(form, fineness(scale * scale * surface_area(probe), style.spacing));
  for (Vector3& x : mesh.vertices) x *= scale;
  const double spacing = std::sqrt(surface_area(mesh) / mesh.vertices.size() * 2 / std::sqrt(3.));
  // Along the ray, so that the surface stays star-shaped.
  const Roughness roughness(style, size / 2, 2.5 * spacing, random);
  for (Vector3& x : mesh.vertices) x *= 1 + roughness.height(x) / x.norm();

  const double correction = size / stone_size(mesh).sieve;
  for (Vector3& x : mesh.vertices) x *= correction;
  const Vector3 centre = mass_properties(mesh).centre;
  for (Vector3& x : mesh.vertices) x -= centre;
  return mesh;
}
} // namespace

std::vector<TriangleMesh> make_stones(int count, std::uint64_t seed, const StoneStyle& style)
{
  if (count < 1)
    throw InputError("The number of stones is " + std::to_string(count) +
                     ", but must be at least 1.");
  check_style(style);
  RandomStream random(seed);
  const std::vector<double> sizes = ballast_sizes(count);
  std::vector<TriangleMesh> stones;
  for (const int i : random.permutation(count))
    stones.push_back(make_stone(sizes[i], seed * 0x9E3779B97F4A7C15u + stones.size(), style));
  return stones;
}
} // namespace interlock::dem
