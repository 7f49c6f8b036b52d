#include "coupling/stones/filling.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// The walls reach far above the box: they are the hopper too.
constexpr double hopper_height = 10; // [m]
} // namespace

void build_box(dem::Engine& engine, const BoxParameters& box, const dem::ContactProperties& contact)
{
  const Vector3 x(box.length, 0, 0), y(0, box.width, 0), z(0, 0, hopper_height), origin(0, 0, 0);
  engine.add_wall(dem::rectangle_wall("floor", origin, x, y, contact));
  engine.add_wall(dem::rectangle_wall("back", x, y, z, contact));
  engine.add_wall(dem::rectangle_wall("right", origin, x, z, contact));
  engine.add_wall(dem::rectangle_wall("left", y, x, z, contact));
  engine.add_wall(dem::rectangle_wall("front", origin, y, z, contact));
}

void open_slot(dem::Engine& engine, const BoxParameters& box, const dem::ContactProperties& contact,
               double height)
{
  const Vector3 y(0, box.width, 0);
  const double bottom = height - 0.5 * box.slot_height, top = height + 0.5 * box.slot_height;
  engine.replace_walls(
      BoxWalls::front,
      {dem::rectangle_wall("front below slot", Vector3(0, 0, 0), y, Vector3(0, 0, bottom), contact),
       dem::rectangle_wall("front above slot", Vector3(0, 0, top), y,
                           Vector3(0, 0, hopper_height - top), contact)});
}

Filling::Filling(dem::Engine& engine, const BoxParameters& box, const FillingParameters& filling,
                 double stone_density)
    : engine_(engine), box_(box), filling_(filling), density_(stone_density),
      n_shapes_(static_cast<int>(engine.clumps().shapes().size())), random_(filling.seed)
{
}

double Filling::pour(double mass)
{
  const dem::Clumps& clumps = engine_.clumps();
  double top = 0;
  for (int i = 0; i < clumps.size(); ++i)
    top = std::max(top, clumps.position[i].z() + clumps.bounding_radius(i));
  const double floor = top + filling_.drop_height;

  std::vector<int> poured;
  double highest = floor;
  for (double sum = 0; sum < mass;) {
    if (batch_.empty()) batch_ = random_.permutation(n_shapes_);
    const int shape = batch_.back();
    batch_.pop_back();
    const double radius = clumps.shapes()[shape].bounding_radius();
    const Vector3 place = lowest_place(radius, floor, poured);
    poured.push_back(engine_.add_clump(shape, density_, place, random_.rotation()));
    sum += clumps.mass[poured.back()];
    highest = std::max(highest, place.z());
  }
  const double lowest_surface = std::max(0., top - 0.1);
  return std::sqrt(2 * (highest - lowest_surface) / engine_.gravity());
}

// Of some random places in plan the one in which the ball comes to lie lowest, above `floor` and
// clear of the balls poured before.
dem::Vector3 Filling::lowest_place(double radius, double floor, const std::vector<int>& poured)
{
  const dem::Clumps& clumps = engine_.clumps();
  const double clearance = 1e-3; // [m]
  Vector3 best(0, 0, 1e300);
  for (int attempt = 0; attempt < 30; ++attempt) {
    const double x = random_.uniform(radius + clearance, box_.length - radius - clearance);
    const double y = random_.uniform(radius + clearance, box_.width - radius - clearance);
    double z = floor + radius;
    for (const int i : poured) {
      const double reach = radius + clumps.bounding_radius(i) + clearance;
      const double plan = std::hypot(x - clumps.position[i].x(), y - clumps.position[i].y());
      if (plan < reach)
        z = std::max(z, clumps.position[i].z() + std::sqrt(reach * reach - plan * plan));
    }
    if (z < best.z()) best = {x, y, z};
  }
  return best;
}

double Filling::surface_height() const
{
  const double spacing = 5e-3; // [m]
  const int nx = std::max(1, static_cast<int>(box_.length / spacing));
  const int ny = std::max(1, static_cast<int>(box_.width / spacing));
  const double dx = box_.length / nx, dy = box_.width / ny;
  std::vector<double> top(nx * ny, 0.);
  const dem::Clumps& clumps = engine_.clumps();
  for (int i = 0; i < clumps.size(); ++i) {
    if (!is_stone(i)) continue;
    const std::vector<dem::Sphere>& spheres = clumps.shape_of(i).spheres;
    for (std::size_t a = 0; a < spheres.size(); ++a) {
      const Vector3 c = clumps.position[i] + clumps.member_offset(i, a);
      const double r = spheres[a].radius;
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
    }
  }
  double sum = 0;
  for (const double z : top) sum += z;
  return sum / top.size();
}

std::vector<bool> Filling::above(double height) const
{
  const dem::Clumps& clumps = engine_.clumps();
  std::vector<bool> result(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) result[i] = clumps.position[i].z() > height;
  return result;
}

std::vector<bool> Filling::lost() const
{
  const dem::Clumps& clumps = engine_.clumps();
  std::vector<bool> result(clumps.size());
  for (int i = 0; i < clumps.size(); ++i)
    result[i] = clumps.position[i].z() < -clumps.bounding_radius(i);
  return result;
}

// The shapes of the surcharge come after those of the stones.
bool Filling::is_stone(int i) const
{
  return engine_.clumps().shape[i] < n_shapes_;
}

bool Filling::in_box(int i) const
{
  const Vector3& x = engine_.clumps().position[i];
  return is_stone(i) && x.x() > 0 && x.x() < box_.length && x.z() > 0;
}

double Filling::mass_in_box() const
{
  return mass_above(-1);
}

double Filling::mass_above(double height) const
{
  const dem::Clumps& clumps = engine_.clumps();
  double mass = 0;
  for (int i = 0; i < clumps.size(); ++i)
    if (in_box(i) && clumps.position[i].z() > height) mass += clumps.mass[i];
  return mass;
}
} // namespace interlock::coupling
