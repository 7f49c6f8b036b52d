// The time step that follows the contacts. Fails when it is not the share asked for of the live
// stable step, when few contacts or none let it grow without bounds, when it rises within a stage
// or stays where contacts have become stiffer, or when a given step is changed.
#include "coupling/loop/world.h"
#include "tests/dem_bodies.h"

#include <gtest/gtest.h>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double r = 0.01;

dem::ContactProperties contact(double stiffness)
{
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = stiffness;
  return pair;
}

// Two balls that overlap by 0.1 mm.
class StepOfAWorld : public testing::Test
{
protected:
  StepOfAWorld() : world({bodies::ball(r)}, contact(1e6), {}, 9.81)
  {
    for (const double x : {0.1, 0.1 + 2 * r - 1e-4})
      world.engine.add_clump(0, 2650, {x, 0.1, 0.1}, dem::Quaternion::Identity());
    world.clock.set_step(1e-6);
    world.compute_forces();
  }
  double live() const { return world.engine.stable_step().step; }

  World world;
};
} // namespace

TEST(StepRule, IsAShareOfTheLiveStepWithinReason)
{
  const StepRule rule{0.5, 1e-6};
  dem::StableStep live;
  EXPECT_DOUBLE_EQ(rule.step(live), 0.7e-6); // no contact yet
  live.step = 0.8e-6;
  EXPECT_DOUBLE_EQ(rule.step(live), 0.4e-6);
  live.step = 1e-3; // two light touches
  EXPECT_DOUBLE_EQ(rule.step(live), 0.7e-6);
}

TEST_F(StepOfAWorld, FollowsWhereAStageBeginsAndFallsWithinIt)
{
  world.step_rule = {0.5, 1};
  world.follow_stable_step();
  EXPECT_DOUBLE_EQ(world.clock.dt, 0.5 * live());
  EXPECT_FALSE(world.keep_below_stable_step());
  const double before = world.clock.dt;
  world.engine.stone_contact() = contact(4e6);
  EXPECT_TRUE(world.keep_below_stable_step());
  EXPECT_NEAR(world.clock.dt, 0.5 * before, 1e-12 * before);
  world.engine.stone_contact() = contact(1e6);
  EXPECT_FALSE(world.keep_below_stable_step());
  EXPECT_NEAR(world.clock.dt, 0.5 * before, 1e-12 * before);
  world.follow_stable_step();
  EXPECT_DOUBLE_EQ(world.clock.dt, before);
}

TEST_F(StepOfAWorld, AGivenStepStays)
{
  world.follow_stable_step();
  EXPECT_FALSE(world.keep_below_stable_step());
  EXPECT_EQ(world.clock.dt, 1e-6);
}
