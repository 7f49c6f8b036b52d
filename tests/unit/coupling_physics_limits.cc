// What ends a run because it is no simulation of anything any more. Fails when a state that has
// left a limit is taken for good, a good one is refused, or the sentence lacks time, stone or
// place.
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_failure.h"

#include <gtest/gtest.h>

#include <limits>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double r = 0.01;

class PhysicsLimit : public testing::Test
{
protected:
  // Two balls with 0.1 mm of overlap, in the middle of a box of 0.2 m.
  PhysicsLimit() : world({ball()}, contact(), {}, 9.81)
  {
    for (const double x : {0.1, 0.1 + 2 * r - 1e-4})
      world.engine.add_clump(0, 2650, {x, 0.1, 0.1}, dem::Quaternion::Identity());
    world.clock.set_step(1e-6);
    world.compute_forces();
    limits.region.min() = Vector3::Zero();
    limits.region.max() = Vector3::Constant(0.2);
    limits.largest_overlap = 2e-4;
    limits.live_stable_step = true;
  }

  static dem::ContactProperties contact()
  {
    dem::ContactProperties pair;
    pair.normal_stiffness = pair.tangential_stiffness = 1e6;
    return pair;
  }
  static dem::ClumpShape ball()
  {
    dem::ClumpShape shape;
    shape.spheres = {{Vector3::Zero(), r}};
    shape.volume = 4 * M_PI / 3 * r * r * r;
    shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * r * r);
    return shape;
  }

  void expect_failure(const std::vector<std::string>& facts) const
  {
    try {
      check_physics(world, limits);
      ADD_FAILURE() << "nothing was found";
    } catch (const RunFailure& failure) {
      const std::string sentence = failure.what();
      EXPECT_EQ(sentence.back(), '.');
      EXPECT_NE(sentence.find("at t = "), std::string::npos) << sentence;
      for (const std::string& fact : facts)
        EXPECT_NE(sentence.find(fact), std::string::npos) << fact << " is not in: " << sentence;
    }
  }

  World world;
  PhysicsLimits limits;
};
} // namespace

TEST_F(PhysicsLimit, AGoodStateIsGood)
{
  EXPECT_NO_THROW(check_physics(world, limits));
}

TEST_F(PhysicsLimit, MotionThatIsNotANumber)
{
  world.engine.clumps().velocity[1] = Vector3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_failure({"stone 1", "not a number", "Safety factor"});
}

// A stone may stick out by its own radius, which no wall lets it, but no farther.
TEST_F(PhysicsLimit, StoneOutsideTheBox)
{
  world.engine.clumps().position[0] = Vector3(0.1, 0.2 + 0.9 * r, 0.1);
  EXPECT_NO_THROW(check_physics(world, limits));
  world.engine.clumps().position[0] = Vector3(0.1, 0.2 + 1.1 * r, 0.1);
  expect_failure({"Stone 0", "outside the box", "0.211"});
}

TEST_F(PhysicsLimit, OverlapAboveItsBound)
{
  limits.largest_overlap = 0.5e-4;
  expect_failure({"stones 0 and 1", "0.1 mm", "0.05 mm"});
}

// Two balls with one contact: omega^2 = 2 k (1/m + r^2/J) by the bound of Engine::stable_step.
TEST_F(PhysicsLimit, StepAboveTheLiveStableOne)
{
  const double live = world.engine.stable_step().step;
  const double m = 2650 * ball().volume, j = 0.4 * m * r * r;
  EXPECT_NEAR(live, 2 / std::sqrt(2 * 1e6 * (1 / m + r * r / j)), 0.02 * live);
  world.clock.set_step(0.99 * live);
  EXPECT_NO_THROW(check_physics(world, limits));
  world.clock.set_step(1.01 * live);
  expect_failure({"live stable step", "Safety factor"});
  limits.live_stable_step = false;
  EXPECT_NO_THROW(check_physics(world, limits));
}
