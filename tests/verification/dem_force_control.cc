// A wall that keeps its force. On columns of balls the force must reach the target and stay within
// 1 % of it (at rest the error falls by 1 - gain a step, so the bound is set by what still
// vibrates), the plate must rest where springs in series put it, its speed never exceed the limit,
// and its work be in the ledger. Stability: with one ball on a bed the characteristic polynomial
// gives 2 s/(2 - gain) + sigma < 4; on either side of the bound the force must settle or not. Fails
// when a sign is wrong, the gain does not follow the number of contacts, or work is lost.
#include "dem/walls/force_control.h"
#include "tests/dem_wall_bench.h"
#include "tests/refusal.h"

#include <gtest/gtest.h>

using namespace wall_bench;

namespace
{
constexpr double r = 0.01, k = 1e6, g = 9.81;

// Balls in a row on the floor, `sunk` into it, under a plate at `height` that is a rectangle or a
// mesh. One layer: frictionless columns would buckle.
struct Press {
  Press(int balls, double sunk, double height, bool is_mesh, double damping)
      : stage({ball(r)}, springs(k, 0, damping), g), is_mesh(is_mesh)
  {
    const ContactProperties pair = springs(k, 0, damping);
    const Vector3 e1(0.1 + 0.03 * balls, 0, 0), e2(0, 0.1, 0), corner(-0.05, -0.05, 0);
    stage.engine.add_wall(rectangle_wall(corner, e1, e2, pair));
    const Vector3 up(0, 0, height);
    if (is_mesh)
      stage.add_mesh(rectangle(corner + up, e1, e2, 4, 3), pair, up);
    else
      stage.engine.add_wall(rectangle_wall(corner + up, e1, e2, pair));
    for (int n = 0; n < balls; ++n) stage.add(0, {0.03 * n, 0, r - sunk}, Vector3::Zero());
    control.axis = {0, 0, -1};
  }

  void step(double dt)
  {
    stage.forces(dt);
    const Clumps& clumps = stage.engine.clumps();
    if (is_mesh) {
      MeshWall& plate = stage.meshes[0];
      force = plate.force.z();
      response = contact_response(stage.contacts.contacts(), 0, plate.contact, clumps, dt);
      control_force(control, response, plate);
      speed = -plate.velocity.z();
    } else {
      Wall& plate = stage.engine.walls()[1];
      force = plate.force.z();
      response = contact_response(stage.engine.wall_contacts(), 1, plate.contact, clumps, dt);
      control_force(control, response, plate);
      speed = -plate.velocity.z();
    }
    largest_speed = std::max(largest_speed, std::abs(speed));
  }
  double height() const
  {
    return is_mesh ? stage.meshes[0].centre.z() : stage.engine.walls()[1].corner.z();
  }

  Stage stage;
  bool is_mesh;
  ForceControl control;
  double force = 0, response = 0, speed = 0, largest_speed = 0;
};
} // namespace

TEST(ForceControl, PlateReachesHoldsAndFollowsTheForce)
{
  const double dt = 5e-6;
  for (const bool is_mesh : {false, true})
    for (const int balls : {1, 5, 20})
      for (const double gain : {0.2, 0.5, 0.8}) {
        Press press(balls, 0, 2.1 * r, is_mesh, 0.2);
        press.control.largest_speed = 0.05;
        press.control.gain = gain;
        const double weight = press.stage.engine.clumps().mass[0] * g;
        for (const double target : {40. * balls, 10. * balls, 80. * balls}) {
          press.control.force = target;
          press.step(dt);
          if (press.response == 0) {
            EXPECT_EQ(press.speed, 0.05); // towards the stones
          }
          press.stage.move(dt);
          for (int n = 0; n < 8000; ++n) {
            press.step(dt);
            if (n > 7000) {
              ASSERT_NEAR(press.force, target, 0.01 * target) << balls << " " << gain;
            }
            press.stage.move(dt);
          }
          // Two springs in series above and below each ball, which weighs something.
          const double squeezed = (2 * target / balls + weight) / k;
          EXPECT_NEAR(press.height(), 2 * r - squeezed, 0.01 * squeezed) << balls << " " << gain;
        }
        EXPECT_LE(press.largest_speed, 0.05);
      }
}

// What the plate puts in is in the springs, the balls' motion and the dashpots.
TEST(ForceControl, WorkIsInTheLedger)
{
  const double dt = 5e-6;
  for (const bool is_mesh : {false, true}) {
    Press press(6, 0, 2.02 * r, is_mesh, 0.2);
    press.control.force = 300;
    press.control.largest_speed = 0.05;
    press.step(dt);
    const double start = press.stage.ledger(dt);
    for (int n = 0; n < 8000; ++n) press.stage.move(dt), press.step(dt);
    const double work =
        is_mesh ? press.stage.meshes[0].work() : press.stage.engine.energy(dt).wall_work;
    const double each = press.force / 6;
    EXPECT_GT(work, 6 * 2 * 0.5 * each * each / k); // two springs a ball
    EXPECT_NEAR(press.stage.ledger(dt), start, 1e-3 * work);
  }
}

// Stones that sink under the plate, here on a floor that goes down, feel the whole force too.
TEST(ForceControl, SteadilyMovingStonesFeelTheForce)
{
  const double dt = 5e-6;
  for (const bool is_mesh : {false, true}) {
    Press press(5, 0, 2.02 * r, is_mesh, 0.3);
    press.stage.engine.walls()[0].velocity = {0, 0, -0.02};
    press.control.force = 200;
    press.control.largest_speed = 0.05;
    for (int n = 0; n < 8000; ++n) {
      press.step(dt);
      if (n > 6000) {
        ASSERT_NEAR(press.force, 200, 2) << is_mesh;
      }
      press.stage.move(dt);
    }
    EXPECT_NEAR(press.speed, 0.02, 2e-4);
  }
}

// A wall handed to the engine keeps its force, and no longer after the walls were replaced.
TEST(ForceControl, EngineKeepsTheForceOfAWall)
{
  const double dt = 5e-6;
  Press press(6, 0, 2.02 * r, false, 0.2);
  Engine& engine = press.stage.engine;
  press.control.force = 300;
  press.control.largest_speed = 0.05;
  EXPECT_TRUE(engine.controlled_walls_press(1)); // there are none
  engine.control_wall(1, press.control);
  press.stage.forces(dt);
  EXPECT_FALSE(engine.controlled_walls_press(0.9)); // on its way
  press.stage.move(dt);
  for (int n = 0; n < 8000; ++n) press.stage.forces(dt), press.stage.move(dt);
  EXPECT_NEAR(engine.walls()[1].force.z(), 300, 3);
  EXPECT_TRUE(engine.controlled_walls_press(0.9));
  EXPECT_FALSE(engine.controlled_walls_press(1.1));
  engine.set_controlled_force(1, 150);
  for (int n = 0; n < 8000; ++n) press.stage.forces(dt), press.stage.move(dt);
  EXPECT_NEAR(engine.walls()[1].force.z(), 150, 1.5);
  EXPECT_THROW(engine.set_controlled_force(0, 150), std::invalid_argument);

  const Wall plate = engine.walls()[1];
  engine.remove_walls({plate.id});
  const WallId id = engine.add_wall(plate);
  engine.wall(id).velocity = Vector3::Zero();
  const double height = press.height();
  for (int n = 0; n < 100; ++n) press.stage.forces(dt), press.stage.move(dt);
  EXPECT_EQ(press.height(), height);
  expect_refusal([&] { engine.control_wall(id, ForceControl{}); }, "Force control", {"speed"});
}

// One ball between plate and floor, no damping but the control's: settles inside the bound, and
// not outside.
TEST(ForceControl, StabilityBoundIsExactForOneBall)
{
  const double m = 2650 * ball(r).volume;
  for (const double gain : {0.3, 0.5, 0.8}) {
    const double rate = 2 / (2 - gain) + 1; // of 2 s/(2 - gain) + sigma, in k dt^2/m
    for (const double share : {0.9, 1.1}) {
      const double dt = std::sqrt(share * 4 / rate * m / k);
      // Near its equilibrium, or the plate would lose the ball.
      Press press(1, (100 + m * g) / k, 2 * r - (200 + m * g) / k - 1e-6, false, 0);
      press.control.force = 100;
      press.control.largest_speed = 10;
      press.control.gain = gain;
      double largest = 0;
      for (int n = 0; n < 4000; ++n) {
        press.step(dt);
        if (n > 3000) largest = std::max(largest, std::abs(press.force / 100 - 1));
        press.stage.move(dt);
      }
      if (share < 1)
        EXPECT_LT(largest, 0.01) << gain;
      else
        EXPECT_GT(largest, 0.3) << gain;
    }
  }
}

// Balls of very different mass, many of them: stable when the step is so with the raised stiffness.
TEST(ForceControl, ManyUnequalContacts)
{
  const double light = 2650 * ball(r).volume;
  for (const double gain : {0.5, 0.8}) {
    const double dt = 0.95 * std::sqrt(4 / (2 / (2 - gain) + 1) * light / k);
    Press press(30, 30 / k, 2 * r - 60 / k, true, 0);
    for (int i = 0; i < 30; ++i) {
      Clumps& c = press.stage.engine.clumps();
      const double factor = 1 + 3 * (i % 5);
      c.mass[i] *= factor;
      c.inertia[i] *= factor;
      c.inverse_mass[i] /= factor;
      c.inverse_inertia[i] /= factor;
      c.position[i].z() -= 1e-6 * (i % 3);
    }
    press.control.force = 900;
    press.control.largest_speed = 1;
    press.control.gain = gain;
    double largest = 0;
    for (int n = 0; n < 20000; ++n) {
      press.step(dt);
      if (n > 19000) largest = std::max(largest, std::abs(press.force / 900 - 1));
      press.stage.move(dt);
    }
    EXPECT_LT(largest, 0.05) << gain;
  }
}

TEST(ForceControl, BadEntriesAreRefused)
{
  ForceControl good;
  good.force = 100;
  good.largest_speed = 0.1;
  EXPECT_NO_THROW(check(good));
  const auto refused = [&](auto change, const std::string& fact) {
    ForceControl bad = good;
    change(bad);
    expect_refusal([&] { check(bad); }, "Force control", {fact});
  };
  refused([](ForceControl& c) { c.axis *= 2; }, "length 1");
  refused([](ForceControl& c) { c.force = -3; }, "-3 N");
  refused([](ForceControl& c) { c.largest_speed = 0; }, "largest speed is 0");
  refused([](ForceControl& c) { c.gain = 1.5; }, "gain is 1.5");
  refused([](ForceControl& c) { c.gain = std::nan(""); }, "gain is nan");
}
