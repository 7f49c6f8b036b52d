// Measures of form against closed forms of simple solids. Fails when an axis, the sieve size, the
// sphericity, the convexity, the angularity or the relief of a rough surface is not what it is
// defined to be.
#include "dem/stones/stone_form.h"

#include "dem/input_error.h"
#include "dem/meshes/mass_properties.h"
#include "dem/stones/angularity.h"
#include "dem/stones/convex_hull.h"
#include "dem/stones/geodesic_sphere.h"
#include "dem/stones/roughness.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

// End-on through a square hole: a nearly square section goes straight, a thin one along the
// diagonal, where the sides of the square are (b + c)/sqrt(2).
TEST(StoneSize, SieveOfABox)
{
  const Vector3 x(1, 0, 0);
  EXPECT_NEAR(sieve_size(solids::box(5, 4, 3).vertices, x), 4, 1e-4 * 4);
  EXPECT_NEAR(sieve_size(solids::box(5, 4, 1).vertices, x), 5 / std::sqrt(2.), 2e-3 * 4);
  const StoneSize size = stone_size(solids::box(2, 5, 4));
  EXPECT_NEAR(size.longest, 5, 1e-12);
  EXPECT_NEAR(size.elongation(), 0.8, 1e-12);
  EXPECT_NEAR(size.flatness(), 0.5, 1e-12);
  EXPECT_NEAR(size.sphericity, std::cbrt(M_PI * 36 * 1600) / 76, 1e-12);
}

// A cube with one corner pushed in: the hull has lost the corner's tetrahedron, 1/6 of the cube.
TEST(ConvexHull, VolumeOfACubeWithADent)
{
  TriangleMesh cube = solids::box(1, 1, 1);
  EXPECT_NEAR(convex_hull_volume(cube.vertices), 1, 1e-12);
  EXPECT_NEAR(stone_form(cube).convexity, 1, 1e-12);
  cube.vertices[7] = Vector3(0.1, 0.1, 0.1);
  EXPECT_NEAR(convex_hull_volume(cube.vertices), 5. / 6, 1e-12);
  EXPECT_NEAR(stone_form(cube).convexity, mass_properties(cube).volume * 6 / 5, 1e-12);
}

TEST(ConvexHull, RefusesPointsWithoutVolume)
{
  EXPECT_THROW(convex_hull_volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), interlock::InputError);
  EXPECT_THROW(convex_hull_volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
               interlock::InputError);
}

// A polygon that steps over the corner of a square, s before and 1 - s after it, turns there by
// atan((1 - s)/s) and the rest of the right angle; one that meets the corner turns by 90 degrees.
// Twelve places for the first vertex are twelve values of s.
TEST(Angularity, OfABallAndOfACube)
{
  EXPECT_EQ(angularity_index(geodesic_sphere(12)), 0);
  const auto tens = [](double angle) { return 10 * std::floor(angle / 10 + 1e-9); };
  double expected = 4 * 2 * 90. / 12;
  for (int k = 1; k < 12; ++k) {
    const double s = k / 12., first = std::atan((1 - s) / s) * 180 / M_PI, second = 90 - first;
    expected += 4 * (tens(first) + tens(second) + tens(std::abs(first - second))) / 12;
  }
  // Sides that differ by 1 % fix the axes; the outline's 720 rays cut corners by 1/4 degree.
  const double index = angularity_index(solids::subdivide(solids::box(1, 1.01, 0.99), 10));
  EXPECT_NEAR(index, expected, 0.1 * expected);
}

TEST(NodeSpacing, OfAnOctahedron)
{
  const NodeSpacing spacing = node_spacing(solids::octahedron(0.03));
  EXPECT_NEAR(spacing.mean, 0.03, 1e-15);
  EXPECT_NEAR(spacing.variation, 0, 1e-7);
}

// Octaves of 16, 8 and 4 mm; mean squares add up. Points all over a large box, 400 relieves.
TEST(Roughness, HeightsFollowThePowerLaw)
{
  StoneStyle style;
  style.roughness = 1e-4, style.roughness_exponent = 0.8;
  double squares = 0;
  constexpr int draws = 400;
  for (int k = 0; k < draws; ++k) {
    RandomStream random(k);
    const Roughness roughness(style, 0.016, 0.003, random);
    const double height = roughness.height({random.uniform(), random.uniform(), random.uniform()});
    squares += height * height / draws;
  }
  double expected = 0;
  for (const double length : {0.016, 0.008, 0.004})
    expected += 1e-8 * std::pow(length / 0.010, 1.6);
  // The mean of 400 squares of nearly normal numbers scatters by sqrt(2/400) = 7 %.
  EXPECT_NEAR(squares, expected, 0.25 * expected);
}
} // namespace
