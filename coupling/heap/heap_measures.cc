#include "coupling/heap/heap_measures.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
double distance(const HeapStone& stone, const PlanPoint& centre)
{
  return (stone.centre.head<2>() - centre).norm();
}

PlanPoint centroid_of(const std::vector<HeapStone>& stones)
{
  PlanPoint moment = PlanPoint::Zero();
  double mass = 0;
  for (const HeapStone& stone : stones) {
    moment += stone.mass * stone.centre.head<2>();
    mass += stone.mass;
  }
  return mass > 0 ? PlanPoint(moment / mass) : moment;
}

// Of the stones that `choose` takes.
template <class Choose>
double radius_of_gyration(const std::vector<HeapStone>& stones, const PlanPoint& centre,
                          const Choose& choose)
{
  double moment = 0, mass = 0;
  for (const HeapStone& stone : stones) {
    if (!choose(stone)) continue;
    moment += stone.mass * std::pow(distance(stone, centre), 2);
    mass += stone.mass;
  }
  return mass > 0 ? std::sqrt(moment / mass) : 0;
}

double radius_of_half(const std::vector<HeapStone>& stones, const PlanPoint& centre)
{
  std::vector<std::pair<double, double>> by_distance; // distance, mass
  double mass = 0;
  for (const HeapStone& stone : stones) {
    by_distance.emplace_back(distance(stone, centre), stone.mass);
    mass += stone.mass;
  }
  std::sort(by_distance.begin(), by_distance.end());
  double inside = 0;
  for (const auto& [d, m] : by_distance) {
    inside += m;
    // Room for the rounding of two sums in different orders.
    if (inside >= 0.5 * mass * (1 - 1e-12)) return d;
  }
  return 0;
}

// Slope of the least-squares line.
double slope(const std::vector<SurfaceProfile::Ring>& rings)
{
  double r = 0, h = 0;
  for (const auto& ring : rings) {
    r += ring.radius / rings.size();
    h += ring.height / rings.size();
  }
  double rr = 0, rh = 0;
  for (const auto& ring : rings) {
    rr += (ring.radius - r) * (ring.radius - r);
    rh += (ring.radius - r) * (ring.height - h);
  }
  return rh / rr;
}

// A pit near the middle is not the flank: that begins behind the last ring that is high.
std::vector<SurfaceProfile::Ring> flank(const std::vector<SurfaceProfile::Ring>& rings,
                                        double height)
{
  const auto end = std::find_if(rings.begin(), rings.end(),
                                [&](const auto& ring) { return ring.height < 0.2 * height; });
  auto begin = end;
  while (begin != rings.begin() && std::prev(begin)->height < 0.8 * height) --begin;
  return {begin, end};
}

// Sums over the rays of one ring.
struct RingSum {
  double radius = 0, height = 0;
  int rays = 0;

  void add(double r, double h)
  {
    radius += r;
    height += h;
    ++rays;
  }
};

std::vector<SurfaceProfile::Ring> means(const std::vector<RingSum>& sums)
{
  std::vector<SurfaceProfile::Ring> rings;
  for (const RingSum& sum : sums)
    if (sum.rays > 0) rings.push_back({sum.radius / sum.rays, sum.height / sum.rays});
  return rings;
}
} // namespace

PlanSpread plan_spread(const std::vector<HeapStone>& stones)
{
  PlanSpread spread;
  const PlanPoint c = spread.centroid = centroid_of(stones);
  spread.radius_of_gyration = radius_of_gyration(stones, c, [](const auto&) { return true; });
  spread.elongated_radius_of_gyration =
      radius_of_gyration(stones, c, [](const HeapStone& s) { return s.elongated; });
  spread.other_radius_of_gyration =
      radius_of_gyration(stones, c, [](const HeapStone& s) { return !s.elongated; });
  spread.r50 = radius_of_half(stones, c);
  spread.mass_beyond = mass_outside(stones, c, 1.5 * spread.r50);
  for (const HeapStone& stone : stones) {
    const bool beyond = distance(stone, c) > 1.5 * spread.r50;
    ++(stone.elongated ? spread.elongated : spread.others);
    if (beyond) ++(stone.elongated ? spread.elongated_beyond : spread.others_beyond);
  }
  return spread;
}

double mass_outside(const std::vector<HeapStone>& stones, const PlanPoint& centre, double radius)
{
  double mass = 0, outside = 0;
  for (const HeapStone& stone : stones) {
    mass += stone.mass;
    if (distance(stone, centre) > radius) outside += stone.mass;
  }
  return mass > 0 ? outside / mass : 0;
}

HeightMap height_map(const std::vector<dem::Sphere>& spheres, const PlanPoint& centre, double reach,
                     double spacing)
{
  HeightMap map;
  map.spacing = spacing;
  map.nx = map.ny = std::max(1, static_cast<int>(std::ceil(2 * reach / spacing)));
  map.corner = centre - PlanPoint::Constant(0.5 * spacing * map.nx);
  map.height.assign(static_cast<std::size_t>(map.nx) * map.ny, 0.);
  const auto index = [&](double from_corner, int n) {
    return static_cast<int>(std::clamp(std::floor(from_corner / spacing), -1., 1. * n));
  };
  for (const dem::Sphere& sphere : spheres) {
    const PlanPoint c = sphere.centre.head<2>() - map.corner;
    const double r = sphere.radius;
    for (int i = std::max(0, index(c.x() - r, map.nx)); i <= index(c.x() + r, map.nx); ++i)
      for (int j = std::max(0, index(c.y() - r, map.ny)); j <= index(c.y() + r, map.ny); ++j) {
        if (i >= map.nx || j >= map.ny) continue;
        const double rest = r * r - (map.ray(i, j) - sphere.centre.head<2>()).squaredNorm();
        if (rest <= 0) continue;
        double& height = map.height[i * map.ny + j];
        height = std::max(height, sphere.centre.z() + std::sqrt(rest));
      }
  }
  return map;
}

SurfaceProfile surface_profile(const HeightMap& map, const PlanPoint& centre, double ring_width)
{
  constexpr int n_sectors = SurfaceProfile::n_sectors;
  const int n_rings = static_cast<int>(map.spacing * std::hypot(map.nx, map.ny) / ring_width) + 1;
  std::array<std::vector<RingSum>, n_sectors> sums;
  sums.fill(std::vector<RingSum>(n_rings));
  std::vector<RingSum> all(n_rings);
  for (int i = 0; i < map.nx; ++i)
    for (int j = 0; j < map.ny; ++j) {
      const PlanPoint d = map.ray(i, j) - centre;
      const double r = d.norm(), h = map.height[i * map.ny + j];
      const int ring = static_cast<int>(r / ring_width);
      if (ring >= n_rings) continue;
      const double turns = std::atan2(d.y(), d.x()) / (2 * M_PI);
      const int sector = static_cast<int>(std::floor(n_sectors * (turns + 1))) % n_sectors;
      sums[sector][ring].add(r, h);
      all[ring].add(r, h);
    }
  SurfaceProfile profile;
  for (int s = 0; s < n_sectors; ++s) profile.sector[s] = means(sums[s]);
  profile.all = means(all);
  return profile;
}

Repose repose(const SurfaceProfile& profile)
{
  Repose result;
  for (const auto& ring : profile.all) result.height = std::max(result.height, ring.height);
  std::vector<double> angles;
  for (const auto& sector : profile.sector) {
    const auto rings = flank(sector, result.height);
    if (rings.size() >= 3) angles.push_back(180 / M_PI * std::atan(-slope(rings)));
  }
  result.sectors = static_cast<int>(angles.size());
  for (const double angle : angles) result.angle += angle / angles.size();
  double squares = 0;
  for (const double angle : angles) squares += std::pow(angle - result.angle, 2);
  if (angles.size() > 1) result.scatter = std::sqrt(squares / (angles.size() - 1));
  return result;
}
} // namespace interlock::coupling
