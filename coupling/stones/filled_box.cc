#include "coupling/stones/filled_box.h"

#include "dem/generator/union_volume.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

constexpr double ray_spacing = 5e-3; // a tenth of a stone or so [m]

bool is_stone(const dem::Clumps& clumps, int i)
{
  return clumps.kind[i] == dem::BodyKind::stone;
}

bool is_inside(const BoxParameters& box, const Vector3& x)
{
  return x.x() > 0 && x.x() < box.length && x.z() > 0;
}

template <class Function> void for_each_sphere(const dem::Clumps& clumps, int i, const Function& f)
{
  const std::vector<dem::Sphere>& spheres = clumps.shape_of(i).spheres;
  for (std::size_t a = 0; a < spheres.size(); ++a)
    f(Vector3(clumps.position[i] + clumps.member_offset(i, static_cast<int>(a))),
      spheres[a].radius);
}
} // namespace

double surface_height(const dem::Clumps& clumps, const BoxParameters& box)
{
  const int nx = std::max(1, static_cast<int>(box.length / ray_spacing));
  const int ny = std::max(1, static_cast<int>(box.width / ray_spacing));
  const double dx = box.length / nx, dy = box.width / ny;
  std::vector<double> top(nx * ny, 0.);
  for (int i = 0; i < clumps.size(); ++i) {
    if (!is_stone(clumps, i)) continue;
    for_each_sphere(clumps, i, [&](const Vector3& c, double r) {
      const int i0 = std::max(0, static_cast<int>((c.x() - r) / dx)),
                i1 = std::min(nx - 1, static_cast<int>((c.x() + r) / dx));
      const int j0 = std::max(0, static_cast<int>((c.y() - r) / dy)),
                j1 = std::min(ny - 1, static_cast<int>((c.y() + r) / dy));
      for (int m = i0; m <= i1; ++m)
        for (int n = j0; n <= j1; ++n) {
          const double u = (m + 0.5) * dx - c.x(), v = (n + 0.5) * dy - c.y();
          const double rest = r * r - u * u - v * v;
          if (rest > 0) top[m * ny + n] = std::max(top[m * ny + n], c.z() + std::sqrt(rest));
        }
    });
  }
  return std::accumulate(top.begin(), top.end(), 0.) / static_cast<double>(top.size());
}

double highest_point(const dem::Clumps& clumps, double floor)
{
  double top = floor;
  for (int i = 0; i < clumps.size(); ++i)
    for_each_sphere(clumps, i, [&](const Vector3& c, double r) { top = std::max(top, c.z() + r); });
  return top;
}

double highest_ball(const dem::Clumps& clumps)
{
  double top = 0;
  for (int i = 0; i < clumps.size(); ++i)
    top = std::max(top, clumps.position[i].z() + clumps.bounding_radius(i));
  return top;
}

std::vector<bool> clumps_above(const dem::Clumps& clumps, double height)
{
  std::vector<bool> result(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) result[i] = clumps.position[i].z() > height;
  return result;
}

std::vector<bool> clumps_below_floor(const dem::Clumps& clumps)
{
  std::vector<bool> result(clumps.size());
  for (int i = 0; i < clumps.size(); ++i)
    result[i] = clumps.position[i].z() < -clumps.bounding_radius(i);
  return result;
}

int stones(const dem::Clumps& clumps)
{
  int n = 0;
  for (int i = 0; i < clumps.size(); ++i) n += is_stone(clumps, i);
  return n;
}

double mass_above(const dem::Clumps& clumps, const BoxParameters& box, double height)
{
  double mass = 0;
  for (int i = 0; i < clumps.size(); ++i) {
    const Vector3 x = clumps.position[i];
    if (is_stone(clumps, i) && is_inside(box, x) && x.z() > height) mass += clumps.mass[i];
  }
  return mass;
}

double mass_since(const dem::Clumps& clumps, const BoxParameters& box, std::int64_t id)
{
  double mass = 0;
  for (int i = 0; i < clumps.size(); ++i)
    if (is_stone(clumps, i) && clumps.id[i] >= id && is_inside(box, clumps.position[i]))
      mass += clumps.mass[i];
  return mass;
}

SolidVolumes solid_volumes(const dem::Clumps& clumps, const BoxParameters& box)
{
  std::vector<double> unions;
  for (const dem::ClumpShape& shape : clumps.shapes())
    unions.push_back(dem::UnionVolume(shape.spheres).volume());
  SolidVolumes sum;
  for (int i = 0; i < clumps.size(); ++i)
    if (is_stone(clumps, i) && is_inside(box, clumps.position[i])) {
      sum.stones += clumps.shape_of(i).volume;
      sum.clumps += unions[clumps.shape[i]];
    }
  return sum;
}
} // namespace interlock::coupling
