// What a sphere adds to the shape. Fails when the gain misses closed forms, or grows with spheres.
#include "dem/generator/surface_gain.h"
#include "dem/meshes/triangle_mesh.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::dem;

SurfaceGain gain_of(const TriangleMesh& mesh)
{
  return SurfaceGain(mesh.vertices, node_areas(mesh));
}

// Mean distance of the surface of the unit cube from its centre: 2/3 of that of its volume from a
// corner, sqrt(3)/4 + ln(2 + sqrt(3))/2 - pi/24. Source: Bailey, Borwein and Crandall, Box
// integrals, J. Comput. Appl. Math. 206 (2007).
TEST(SurfaceGain, OfTheLargestBallInACube)
{
  const double side = 0.05;
  const double mean =
      2. / 3 * (std::sqrt(3.) / 4 + std::log(2 + std::sqrt(3.)) / 2 - M_PI / 24) * side;
  const SurfaceGain gain = gain_of(solids::subdivide(solids::box(side, side, side), 40));
  const double area = 6 * side * side, diagonal = std::sqrt(3.) * side;
  EXPECT_NEAR(gain.area(), area, 1e-12 * area);
  const double exact = area * (diagonal - (mean - side / 2));
  EXPECT_NEAR(gain.gain({Vector3::Zero(), side / 2}), exact, 2e-4 * exact); // 40 nodes a side
}

TEST(SurfaceGain, OfASphereMadeLarger)
{
  SurfaceGain gain = gain_of(solids::subdivide(solids::box(0.06, 0.05, 0.04), 10));
  const Vector3 centre(0.004, -0.001, 0.002);
  gain.add({centre, 0.010});
  for (const double t : {0.001, 0.005, 0.008})
    EXPECT_NEAR(gain.gain({centre, 0.010 + t}), t * gain.area(), 1e-12 * gain.area());
  EXPECT_EQ(gain.gain({centre, 0.009}), 0);
}

// A ball that reaches beyond the surface gains no more than one that reaches it.
TEST(SurfaceGain, CountsNothingBeyondTheSurface)
{
  SurfaceGain gain = gain_of(solids::subdivide(solids::box(0.06, 0.05, 0.04), 10));
  const Sphere small{Vector3::Zero(), 0.01}, around{Vector3::Zero(), 0.05};
  gain.add(small);
  const double all = gain.gain(around);
  EXPECT_EQ(gain.gain({Vector3::Zero(), 0.07}), all);
  gain.add(around);
  EXPECT_EQ(gain.distance(0), 0);
  EXPECT_EQ(gain.gain({Vector3(0.01, 0, 0), 0.1}), 0);
}

TEST(SurfaceGain, NeverGrows)
{
  SurfaceGain gain = gain_of(solids::subdivide(solids::box(0.06, 0.05, 0.04), 10));
  const Sphere ball{Vector3(0.01, 0.01, 0), 0.015};
  double last = gain.gain(ball);
  for (const double x : {-0.02, 0.015, 0., 0.01}) {
    gain.add({Vector3(x, 0, 0), 0.012});
    EXPECT_LE(gain.gain(ball), last);
    last = gain.gain(ball);
  }
}
} // namespace
