// Spheres that hang together. Fails when spheres that touch or overlap count as apart, when a gap
// is bridged, or when the report of a clump has another number.
#include "dem/generator/clump_generator.h"
#include "dem/generator/sphere_groups.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

TEST(SphereGroups, OfAHandMadeClump)
{
  // Two that overlap, two that touch, one alone, and a small one inside the first.
  std::vector<Sphere> spheres = {{Vector3(0, 0, 0), 0.010},    {Vector3(0.015, 0, 0), 0.010},
                                 {Vector3(0.1, 0, 0), 0.010},  {Vector3(0.13, 0, 0), 0.020},
                                 {Vector3(0, 0.05, 0), 0.010}, {Vector3(0.001, 0, 0), 0.002}};
  EXPECT_EQ(sphere_groups(spheres), 3);
  spheres[3].centre.x() += 1e-6; // a gap of 1 micrometre
  EXPECT_EQ(sphere_groups(spheres), 4);
  spheres.push_back({Vector3(0.05, 0.02, 0), 0.065}); // over all of them
  EXPECT_EQ(sphere_groups(spheres), 1);
  EXPECT_EQ(sphere_groups({}), 0);
}

TEST(SphereGroups, TouchingToWithinRounding)
{
  const double r = 0.1 / 3;
  const Vector3 along = Vector3(1, 2, 3).normalized();
  EXPECT_EQ(sphere_groups({{Vector3(1, 1, 1), r}, {Vector3(1, 1, 1) + 2 * r * along, r}}), 1);
}

// A rod of 100 x 10 x 10 mm: balls of 5 mm near its ends only, and all along it.
TEST(SphereGroups, AreInTheReport)
{
  const TriangleMesh rod = solids::subdivide(solids::box(0.1, 0.01, 0.01), 10);
  ClumpParameters parameters;
  parameters.max_spheres = 2;
  ClumpReport report;
  int pieces = 0;
  for (parameters.seed = 1; parameters.seed <= 5; ++parameters.seed) {
    const ClumpShape clump = make_clump(rod, parameters, &report);
    EXPECT_EQ(report.groups, sphere_groups(clump.spheres));
    pieces += report.groups == 2;
  }
  EXPECT_GT(pieces, 0);
  parameters.max_spheres = 0;
  parameters.r_min = 1e-3; // balls at the corners of a box are tiny and alone
  make_clump(rod, parameters, &report);
  EXPECT_EQ(report.groups, 1);
}
} // namespace
