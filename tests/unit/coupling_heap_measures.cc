// The measures of a heap against heaps whose answers are known: a cone, two cones' flanks, a ring,
// a disc. It takes a wrong centroid, moment, share, quantile, azimuth, fitting range or slope to
// fail.
#include "coupling/heap/heap_measures.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace interlock::coupling;
using interlock::dem::Sphere;
using interlock::dem::Vector3;

namespace
{
// Raster over a surface that is given as a function of the place in plan.
template <class Height> HeightMap raster(const PlanPoint& centre, const Height& height)
{
  HeightMap map = height_map({}, centre, 0.5, 5e-3);
  for (int i = 0; i < map.nx; ++i)
    for (int j = 0; j < map.ny; ++j) map.height[i * map.ny + j] = height(map.ray(i, j));
  return map;
}

std::vector<HeapStone> ring(double radius, int count, double mass, bool elongated,
                            const PlanPoint& centre)
{
  std::vector<HeapStone> stones;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * k / count;
    stones.push_back(
        {{centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle), 0.01 * k},
         mass,
         elongated});
  }
  return stones;
}

void append(std::vector<HeapStone>& stones, const std::vector<HeapStone>& more)
{
  stones.insert(stones.end(), more.begin(), more.end());
}
const PlanPoint off_centre(0.3, -0.7);
} // namespace

TEST(HeapMeasures, ConeHasItsAngle)
{
  for (const double degrees : {15., 30., 42.}) {
    const double steepness = std::tan(degrees * M_PI / 180);
    const HeightMap map = raster(off_centre, [&](const PlanPoint& x) {
      return std::max(0., 0.2 - steepness * (x - off_centre).norm());
    });
    const Repose heap = repose(surface_profile(map, off_centre, 0.02));
    EXPECT_EQ(heap.sectors, 8);
    EXPECT_NEAR(heap.angle, degrees, 1e-9);
    EXPECT_NEAR(heap.scatter, 0, 1e-9);
    EXPECT_NEAR(heap.height, 0.2, 0.02 * steepness);
  }
}

// Half of the plan (y > 0: four sectors) is steeper, so the mean and the scatter are known; stray
// stones far out, a flat top and a pit in it must not change them.
TEST(HeapMeasures, SectorsAreFittedOneByOneOnTheirFlanks)
{
  const double steep = std::tan(35 * M_PI / 180), flat = std::tan(25 * M_PI / 180);
  const HeightMap map = raster(PlanPoint::Zero(), [&](const PlanPoint& x) {
    const double slope = x.y() > 0 ? steep : flat;
    const double cone = 0.2 - slope * x.norm();
    if (x.norm() > 0.47 && x.norm() < 0.49) return 0.1;
    return x.norm() < 0.02 ? 0.12 : std::clamp(cone, 0., 0.17);
  });
  const Repose heap = repose(surface_profile(map, PlanPoint::Zero(), 0.01));
  EXPECT_NEAR(heap.height, 0.17, 1e-12);
  EXPECT_EQ(heap.sectors, 8);
  EXPECT_NEAR(heap.angle, 30, 1e-9);
  EXPECT_NEAR(heap.scatter, 5 * std::sqrt(8. / 7), 1e-9);
}

TEST(HeapMeasures, SingleSectorIsWhereItsAzimuthSays)
{
  // Only between 90 and 135 degrees, clear of both, is there a flank.
  const HeightMap map = raster(PlanPoint::Zero(), [](const PlanPoint& x) {
    const bool inside = x.x() < -5e-3 && x.y() > 5e-3 - x.x();
    return std::max(0., 0.2 - (inside ? 1. : 1e6) * x.norm());
  });
  const SurfaceProfile profile = surface_profile(map, PlanPoint::Zero(), 0.01);
  EXPECT_GT(profile.sector[2][5].height, 0.05);
  EXPECT_EQ(profile.sector[1][5].height, 0);
  EXPECT_EQ(profile.sector[3][5].height, 0);
}

TEST(HeapMeasures, SurfaceIsTheHighestSphereUnderTheRay)
{
  const HeightMap map = height_map({{{0, 0, 0.1}, 0.05}, {{0, 0, 0.05}, 0.07}, {{9, 9, 9}, 1}},
                                   PlanPoint::Zero(), 0.1, 0.01);
  ASSERT_EQ(map.nx, 20);
  for (int i = 0; i < map.nx; ++i)
    for (int j = 0; j < map.ny; ++j) {
      const double d2 = map.ray(i, j).squaredNorm();
      const double high = d2 < 0.05 * 0.05 ? 0.1 + std::sqrt(0.05 * 0.05 - d2) : 0;
      const double wide = d2 < 0.07 * 0.07 ? 0.05 + std::sqrt(0.07 * 0.07 - d2) : 0;
      EXPECT_NEAR(map.height[i * map.ny + j], std::max(high, wide), 1e-15);
    }
}

TEST(HeapMeasures, RingHasItsRadiusOfGyration)
{
  const PlanSpread spread = plan_spread(ring(0.25, 12, 0.06, false, off_centre));
  EXPECT_NEAR((spread.centroid - off_centre).norm(), 0, 1e-14);
  EXPECT_NEAR(spread.radius_of_gyration, 0.25, 1e-14);
  EXPECT_NEAR(spread.r50, 0.25, 1e-14);
  EXPECT_EQ(spread.mass_beyond, 0);
  EXPECT_EQ(spread.others, 12);
  EXPECT_EQ(spread.elongated, 0);
}

// Stones spread evenly over a disc: radius of gyration R/sqrt(2), half of the mass within
// R/sqrt(2), and 1.5 times that is beyond the rim.
TEST(HeapMeasures, DiscOfManyStones)
{
  std::vector<HeapStone> stones;
  const int n = 20000;
  const double golden = M_PI * (3 - std::sqrt(5.));
  for (int k = 0; k < n; ++k) {
    const double r = 0.4 * std::sqrt((k + 0.5) / n);
    stones.push_back({{r * std::cos(golden * k), r * std::sin(golden * k), 0}, 0.05, false});
  }
  const PlanSpread spread = plan_spread(stones);
  EXPECT_NEAR(spread.radius_of_gyration, 0.4 / std::sqrt(2), 1e-4);
  EXPECT_NEAR(spread.r50, 0.4 / std::sqrt(2), 1e-4);
  EXPECT_EQ(spread.mass_beyond, 0);
  EXPECT_NEAR(mass_outside(stones, PlanPoint::Zero(), 0.2), 0.75, 1e-4);
}

// Three rings: 8 kg at 0.1 m, 2 kg at 0.14 m, 1 kg at 0.2 m. Half of the 11 kg lies within 0.1 m,
// so what lies beyond 0.15 m is the last ring.
TEST(HeapMeasures, SharesBeyondTheHeap)
{
  std::vector<HeapStone> stones = ring(0.1, 8, 1, false, off_centre);
  append(stones, ring(0.14, 4, 0.5, true, off_centre));
  append(stones, ring(0.2, 4, 0.25, true, off_centre));
  stones.back().elongated = false;
  const PlanSpread spread = plan_spread(stones);
  EXPECT_NEAR(spread.r50, 0.1, 1e-14);
  EXPECT_NEAR(spread.mass_beyond, 1. / 11, 1e-14);
  EXPECT_EQ(spread.elongated, 7);
  EXPECT_EQ(spread.others, 9);
  EXPECT_EQ(spread.elongated_beyond, 3);
  EXPECT_EQ(spread.others_beyond, 1);
  EXPECT_NEAR(spread.elongated_radius_of_gyration, std::sqrt((2 * 0.0196 + 0.75 * 0.04) / 2.75),
              1e-14);
  EXPECT_NEAR(spread.other_radius_of_gyration, std::sqrt((8 * 0.01 + 0.25 * 0.04) / 8.25), 1e-14);
  EXPECT_NEAR(mass_outside(stones, off_centre, 0.12), 3. / 11, 1e-14);
}

TEST(HeapMeasures, NoStonesNoNumbers)
{
  EXPECT_EQ(plan_spread({}).radius_of_gyration, 0);
  EXPECT_EQ(
      repose(surface_profile(height_map({}, PlanPoint::Zero(), 0.1, 0.01), PlanPoint::Zero(), 0.02))
          .sectors,
      0);
}
