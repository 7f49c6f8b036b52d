// Small spheres inside the surface of a clump. It takes a new sphere that sticks out of the union
// of the old ones, one that does not touch its surface, a changed mass, or a radius outside its
// range, to fail.
#include "dem/bodies/refined_shape.h"

#include "dem/input_error.h"

#include <gtest/gtest.h>

using namespace interlock;
using namespace interlock::dem;

namespace
{
constexpr RadiusRange range{1.5e-3, 3e-3};
constexpr double tolerance = 1e-12; // [m]

ClumpShape stone()
{
  ClumpShape shape;
  shape.name = "stone";
  shape.spheres = {{{0, 0, 0}, 0.015},         {{0.008, 0.002, 0}, 0.012},
                   {{-0.009, 0, 0.004}, 0.01}, {{0, 0.012, -0.003}, 0.007},
                   {{0, -0.013, 0}, 0.002},    {{0.001, 0, 0}, 0.003}};
  shape.volume = 1e-5;
  shape.unit_inertia = {1e-9, 1.1e-9, 1.2e-9};
  return shape;
}
} // namespace

TEST(RefinedShape, NewSpheresTouchTheSurfaceFromInside)
{
  const ClumpShape before = stone();
  RandomStream random(3);
  const ClumpShape after = refined_shape(before, 500, range, random);
  ASSERT_EQ(after.spheres.size(), 500u);
  for (std::size_t k = 0; k < before.spheres.size(); ++k)
    EXPECT_EQ(after.spheres[k].centre, before.spheres[k].centre);
  for (std::size_t k = before.spheres.size(); k < after.spheres.size(); ++k) {
    const Sphere& small = after.spheres[k];
    EXPECT_GE(small.radius, range.smallest);
    EXPECT_LE(small.radius, range.largest);
    // Inside one of the old spheres, touching it where no other one covers the point.
    bool touches = false;
    for (const Sphere& outer : before.spheres) {
      const Vector3 arm = small.centre - outer.centre;
      if (std::abs(arm.norm() + small.radius - outer.radius) > tolerance) continue;
      const Vector3 point = outer.centre + outer.radius * arm.normalized();
      bool covered = false;
      for (const Sphere& other : before.spheres)
        covered = covered || (point - other.centre).norm() < other.radius - tolerance;
      touches = touches || !covered;
    }
    EXPECT_TRUE(touches) << k;
  }
  EXPECT_EQ(after.volume, before.volume);
  EXPECT_EQ(after.unit_inertia, before.unit_inertia);
}

// The surface along rays from far outside: the farthest point of the union in a direction.
TEST(RefinedShape, HasTheSameOutline)
{
  const ClumpShape before = stone();
  RandomStream random(4), rays(5);
  const ClumpShape after = refined_shape(before, 300, range, random);
  const auto support = [](const ClumpShape& shape, const Vector3& direction) {
    double farthest = -1;
    for (const Sphere& s : shape.spheres)
      farthest = std::max(farthest, direction.dot(s.centre) + s.radius);
    return farthest;
  };
  for (int k = 0; k < 1000; ++k) {
    const Vector3 direction = rays.direction();
    EXPECT_NEAR(support(after, direction), support(before, direction), 1e-9);
  }
}

TEST(RefinedShape, SameSeedSameSpheres)
{
  RandomStream first(1), second(1), other(2);
  const ClumpShape a = refined_shape(stone(), 60, range, first),
                   b = refined_shape(stone(), 60, range, second),
                   c = refined_shape(stone(), 60, range, other);
  ASSERT_EQ(a.spheres.size(), 60u);
  ASSERT_EQ(b.spheres.size(), 60u);
  ASSERT_EQ(c.spheres.size(), 60u);
  for (std::size_t k = 0; k < a.spheres.size(); ++k) {
    EXPECT_EQ(a.spheres[k].centre, b.spheres[k].centre);
    EXPECT_EQ(a.spheres[k].radius, b.spheres[k].radius);
    if (k < stone().spheres.size()) continue;
    // Another seed draws every one of the small spheres anew, size and place.
    EXPECT_GT((a.spheres[k].centre - c.spheres[k].centre).norm(), 1e-9) << k;
    EXPECT_GT(std::abs(a.spheres[k].radius - c.spheres[k].radius), 1e-9) << k;
  }
}

TEST(RefinedShape, RefusesWhatCannotBe)
{
  RandomStream random(1);
  EXPECT_EQ(refined_shape(stone(), 6, range, random).spheres.size(), 6u);
  EXPECT_THROW(refined_shape(stone(), 5, range, random), InputError);
  EXPECT_THROW(refined_shape(stone(), 20, {0.02, 0.03}, random), InputError);
}
