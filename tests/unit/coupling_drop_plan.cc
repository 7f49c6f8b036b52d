// The plan of a drop and the poses of clumps with other mass properties. It takes member spheres
// that lie elsewhere under another mass scheme, a shape that does not start from its own place in
// each batch, places outside the disc, stones that touch while they fall, or a stone that could
// have been let go sooner, a fall
// that depends on the step, to fail.
#include "coupling/heap/drop_plan.h"
#include "dem/engine/engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double gravity = 9.81;

StoneParameters stones_with(const std::string& mass_properties)
{
  StoneParameters p;
  p.count = 5;
  p.density = 2650;
  p.d_min = 1e-3;
  p.r_min = 2e-3;
  p.p_max = 100;
  p.max_spheres = 25;
  p.mass_properties = mass_properties;
  return p;
}

DropParameters small_drop()
{
  DropParameters drop;
  drop.seed = 3;
  drop.batches = 3;
  drop.height = 1;
  drop.disc_radius = 0.03;
  return drop;
}

std::vector<dem::ClumpShape> shapes_of(const std::vector<Stone>& stones)
{
  std::vector<dem::ClumpShape> shapes;
  for (const Stone& stone : stones) shapes.push_back(stone.shape);
  return shapes;
}

// World centres of the member spheres of one release.
std::vector<Vector3> members(const Stone& stone, const Release& release)
{
  const BodyPose pose = body_pose(stone, release.place, release.attitude);
  std::vector<Vector3> result;
  for (const dem::Sphere& s : stone.shape.spheres)
    result.push_back(pose.position + pose.orientation * s.centre);
  return result;
}
} // namespace

TEST(DropPlan, MemberSpheresLieAtTheSamePlacesWhateverTheirMass)
{
  const std::vector<Stone> mesh = make_stones(stones_with("mesh"), {});
  for (const char* scheme : {"uniform", "equal-mass"}) {
    const std::vector<Stone> other = make_stones(stones_with(scheme), {});
    const auto plan = plan_drop(mesh, small_drop(), gravity);
    const auto other_plan = plan_drop(other, small_drop(), gravity);
    ASSERT_EQ(plan.size(), 15u);
    double body_frames_differ = 0;
    for (std::size_t k = 0; k < plan.size(); ++k) {
      const Stone &a = mesh[plan[k].stone], &b = other[other_plan[k].stone];
      EXPECT_EQ(plan[k].time, other_plan[k].time);
      const auto x = members(a, plan[k]), y = members(b, other_plan[k]);
      ASSERT_EQ(x.size(), y.size());
      for (std::size_t s = 0; s < x.size(); ++s) {
        EXPECT_NEAR((x[s] - y[s]).norm(), 0, 1e-12);
        EXPECT_EQ(a.shape.spheres[s].radius, b.shape.spheres[s].radius);
      }
      body_frames_differ = std::max(body_frames_differ, (a.centre - b.centre).norm());
    }
    EXPECT_GT(body_frames_differ, 1e-4) << "the schemes must differ for this to mean anything";
  }
}

// With the mass properties of the closed surface the body frame has the stone's own centre.
TEST(DropPlan, MeshSchemeHasItsCentreInTheStone)
{
  for (const Stone& stone : make_stones(stones_with("mesh"), {}))
    EXPECT_NEAR(stone.centre.norm(), 0, 1e-15);
}

TEST(DropPlan, EveryShapeHasItsOwnPlaceInEachBatch)
{
  const std::vector<Stone> stones = make_stones(stones_with("mesh"), {});
  const auto plan = plan_drop(stones, small_drop(), gravity);
  for (std::size_t k = 0; k < plan.size(); ++k) {
    EXPECT_EQ(plan[k].stone, static_cast<int>(k % 5));
    EXPECT_EQ(plan[k].place, plan[k % 5].place);
    EXPECT_EQ(plan[k].place.z(), 1);
    EXPECT_LE(plan[k].place.head<2>().norm(), 0.03);
    if (k == 0) continue;
    EXPECT_GT(plan[k].attitude.angularDistance(plan[k - 1].attitude), 1e-3);
    EXPECT_GE(plan[k].time, plan[k - 1].time);
    EXPECT_NE(plan[k].place, plan[k - 1].place);
  }
  auto other = small_drop();
  other.seed = 4;
  EXPECT_NE(plan_drop(stones, other, gravity)[0].place, plan[0].place);
}

// All stones in free fall, at every release: no two member spheres overlap, but a millisecond
// sooner two would have been nearer than the clearance where the stone had to wait.
TEST(DropPlan, StonesFallWithoutTouchingAndAsSoonAsTheyCan)
{
  const std::vector<Stone> stones = make_stones(stones_with("mesh"), {});
  const auto plan = plan_drop(stones, small_drop(), gravity);
  const auto fall = [&](std::size_t last, double time, double swell) {
    std::vector<dem::ClumpShape> shapes = shapes_of(stones);
    for (dem::ClumpShape& shape : shapes)
      for (dem::Sphere& sphere : shape.spheres) sphere.radius += 0.5 * swell;
    dem::Engine engine(shapes, {}, gravity);
    for (std::size_t k = 0; k <= last; ++k) {
      BodyPose pose = body_pose(stones[plan[k].stone], plan[k].place, plan[k].attitude);
      const double since = std::max(0., time - plan[k].time);
      pose.position.z() -= 0.5 * gravity * since * since;
      engine.add_clump(plan[k].stone, 2650, pose.position, pose.orientation);
    }
    return engine.count_overlaps_brute_force();
  };
  int waited = 0;
  for (std::size_t k = 1; k < plan.size(); ++k) {
    EXPECT_EQ(fall(k, plan[k].time, 0.999e-3), 0) << k;
    EXPECT_EQ(fall(k, plan[k].time + 0.1, 0), 0) << k;
    if (plan[k].time == plan[k - 1].time) continue;
    ++waited;
    EXPECT_GT(fall(k, plan[k].time - 1e-3, 1.001e-3), 0) << k;
  }
  EXPECT_GT(waited, 5);
}

// Stones enter between two steps of any length, and follow the parabola of their release.
TEST(DropPlan, FallDoesNotDependOnTheStep)
{
  const std::vector<Stone> stones = make_stones(stones_with("equal-mass"), {});
  const auto plan = plan_drop(stones, small_drop(), gravity);
  for (const double dt : {0.7e-3, 1.3e-4}) {
    const Release& release = plan[4];
    const Stone& stone = stones[release.stone];
    const double enters = dt * std::ceil(release.time / dt);
    const FallingStone start = falling_stone(stone, release, enters, dt, gravity);
    dem::Engine engine(shapes_of(stones), {}, gravity);
    engine.add_clump(release.stone, 2650, start.pose.position, start.pose.orientation,
                     start.velocity);
    const int steps = 200;
    for (int k = 0; k < steps; ++k) engine.step(dt);
    const double since = enters + steps * dt - release.time;
    Release later = release;
    later.place.z() -= 0.5 * gravity * since * since;
    const auto expected = members(stone, later);
    for (std::size_t a = 0; a < expected.size(); ++a) {
      const Vector3 x =
          engine.clumps().position[0] + engine.clumps().member_offset(0, static_cast<int>(a));
      EXPECT_NEAR((x - expected[a]).norm(), 0, 1e-12);
    }
  }
}
