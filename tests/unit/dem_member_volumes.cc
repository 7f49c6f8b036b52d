// The shares of the member spheres sum to the volume, centre and inertia of the stone. Fails when a
// sum is off by more than rounding where positive shares exist, when a share is not positive, or
// when clumps of few spheres get no volume.
#include "dem/export/member_volumes.h"
#include "dem/meshes/mass_properties.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

// Balls at the points of a grid inside an ellipsoid, which together are heavier and wider than it.
ClumpShape ellipsoid()
{
  const Vector3 axes(0.03, 0.02, 0.015);
  ClumpShape shape;
  for (double x = -0.024; x < 0.025; x += 0.006)
    for (double y = -0.016; y < 0.017; y += 0.006)
      for (double z = -0.012; z < 0.013; z += 0.006) {
        const Vector3 c(x, y, z);
        if (c.cwiseQuotient(axes).norm() < 0.95) shape.spheres.push_back({c, 0.005 + 0.05 * x});
      }
  const Vector3 square = axes.cwiseAbs2();
  shape.volume = 4. / 3 * M_PI * axes.prod();
  shape.unit_inertia = shape.volume / 5 * (Vector3::Constant(square.sum()) - square);
  return shape;
}

TEST(MemberVolumes, SumToTheStone)
{
  const ClumpShape shape = ellipsoid();
  ASSERT_GT(shape.spheres.size(), 50u);
  const auto volumes = member_volumes(shape);
  for (const double volume : volumes) EXPECT_GT(volume, 0);
  const MassProperties sums = mass_properties(shape.spheres, volumes);
  EXPECT_NEAR(sums.volume, shape.volume, 1e-12 * shape.volume);
  EXPECT_LT(sums.centre.norm(), 1e-12 * shape.bounding_radius());
  const Matrix3 expected = shape.unit_inertia.asDiagonal();
  EXPECT_LT((sums.inertia - expected).norm(), 1e-12 * expected.norm());
}

// Two balls on the z axis cannot spin like anything else: the lever rule gives their shares.
TEST(MemberVolumes, LeverOfTwoBalls)
{
  ClumpShape shape;
  shape.spheres = {{{0, 0, 0.01}, 0.02}, {{0, 0, -0.03}, 0.01}};
  shape.volume = 4e-5;
  shape.unit_inertia = Vector3(1, 1, 1) * 1e-8;
  const auto volumes = member_volumes(shape);
  EXPECT_NEAR(volumes[0], 3e-5, 1e-16);
  EXPECT_NEAR(volumes[1], 1e-5, 1e-16);
}

// A single ball off the centre can carry the volume only.
TEST(MemberVolumes, OneBall)
{
  ClumpShape shape;
  shape.spheres = {{{0.001, 0, 0}, 0.02}};
  shape.volume = 4e-5;
  shape.unit_inertia = Vector3(1, 2, 3) * 1e-9;
  EXPECT_DOUBLE_EQ(member_volumes(shape)[0], 4e-5);
}
} // namespace
