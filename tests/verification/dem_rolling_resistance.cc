// Rolling resistance of single spheres against closed forms: v' = -(5/7) mu_r g on a plane, then
// rest; held on a slope below tan = mu_r and v' = (5/7) g (sin - mu_r cos) above; in a turning drum
// a ball rolls in place where the slope is mu_r. Fails when the moment, its limit, its sign on
// either body or the rolling radius is wrong, when it keeps swinging about zero instead of resting,
// when springs are lost on a mesh, or when the ledger stays open.
#include "dem/engine/rolling_resistance.h"
#include "tests/dem_wall_bench.h"

#include <gtest/gtest.h>

using namespace wall_bench;

namespace
{
constexpr double r = 0.01, k = 1e5, g = 9.81, dt = 5e-6;

// A stage whose contacts resist rolling.
struct RollingStage : Stage {
  RollingStage(const ContactProperties& pair, double gravity, const RollingProperties& rolling)
      : Stage({ball(r)}, pair, gravity), rolling(rolling), pair(pair)
  {
  }

  void forces(double time_step)
  {
    Stage::forces(time_step);
    std::vector<RollingContact> list;
    append_rolling(engine.sphere_contacts(), engine.clumps(), pair.normal_stiffness, rolling, list);
    append_rolling(engine.wall_contacts(), engine.clumps(), engine.walls(), rolling, list);
    append_rolling(contacts.contacts(), engine.clumps(), meshes, rolling, list);
    stored += resistance.evaluate(list, engine.clumps(), meshes, time_step);
  }

  void run(int steps)
  {
    for (int n = 0; n < steps; ++n) {
      forces(dt);
      move(dt);
    }
  }

  RollingProperties rolling;
  ContactProperties pair;
  RollingResistance resistance;
};

// The plane through the origin that falls along x by `slope` [rad], and a ball on it.
RollingStage on_slope(double slope, bool is_mesh, double mu_r, double speed)
{
  const ContactProperties pair = springs(k, 0.6, 0.3);
  RollingStage stage(pair, g, {mu_r, 0.3});
  const Vector3 down(std::cos(slope), 0, -std::sin(slope)), across(0, 1, 0);
  const Vector3 corner = -0.1 * down - 0.1 * across;
  if (is_mesh)
    stage.add_mesh(rectangle(corner, 0.5 * down, 0.2 * across, 60, 20), pair);
  else
    stage.engine.add_wall(rectangle_wall(corner, 0.5 * down, 0.2 * across, pair));
  const double m = 2650 * ball(r).volume;
  const Vector3 normal(std::sin(slope), 0, std::cos(slope));
  stage.add(0, (r - m * g * std::cos(slope) / k) * normal, speed * down, speed / r * across);
  return stage;
}
} // namespace

TEST(RollingResistance, RollingBallStopsAndRests)
{
  const double mu_r = 0.08, v0 = 0.2, deceleration = 5. / 7 * mu_r * g;
  for (const bool is_mesh : {false, true}) {
    RollingStage stage = on_slope(0, is_mesh, mu_r, v0);
    const Clumps& c = stage.engine.clumps();
    stage.forces(dt);
    const double start = stage.ledger(dt), kinetic = stage.engine.kinetic_energy();
    stage.move(dt);
    const int stop = static_cast<int>(v0 / deceleration / dt);
    stage.run(stop / 4);
    const double early = c.velocity[0].x(), x_early = c.position[0].x();
    const double lost_early = stage.engine.energy(dt).contact.friction;
    stage.run(stop / 2);
    const double late = c.velocity[0].x();
    EXPECT_NEAR((early - late) / (stop / 2 * dt), deceleration, 1e-3 * deceleration);
    EXPECT_NEAR(c.spin[0].y(), late / r, 1e-3 * late / r);
    stage.run(stop / 2);
    const double x = c.position[0].x();
    EXPECT_NEAR(x - x_early, 0.5 * early * early / deceleration, 2e-3 * x);
    // All that it had is lost to slip of the rolling spring.
    const double kinetic_early = 0.7 * c.mass[0] * early * early;
    EXPECT_NEAR(stage.engine.energy(dt).contact.friction - lost_early, kinetic_early,
                2e-3 * kinetic_early);
    stage.run(stop / 2);
    EXPECT_LT(stage.engine.kinetic_energy(), 1e-12 * kinetic);
    EXPECT_NEAR(c.position[0].x(), x, 1e-5 * x);
    stage.forces(dt);
    EXPECT_NEAR(stage.ledger(dt), start, 1e-4 * kinetic);
  }
}

TEST(RollingResistance, SlopesHoldUpToTheCoefficient)
{
  const double mu_r = 0.2;
  for (const bool is_mesh : {false, true}) {
    RollingStage holds = on_slope(std::atan(0.95 * mu_r), is_mesh, mu_r, 0);
    holds.run(40000);
    EXPECT_LT(holds.engine.clumps().position[0].norm(), r + 2e-5);
    EXPECT_LT(holds.engine.clumps().velocity[0].norm(), 1e-6);

    const double slope = std::atan(1.2 * mu_r);
    RollingStage rolls = on_slope(slope, is_mesh, mu_r, 0);
    rolls.run(10000);
    const double v = rolls.engine.clumps().velocity[0].norm();
    rolls.run(30000);
    const double a = 5. / 7 * g * (std::sin(slope) - mu_r * std::cos(slope));
    EXPECT_NEAR((rolls.engine.clumps().velocity[0].norm() - v) / (30000 * dt), a, 0.005 * a);
  }
}

TEST(RollingResistance, ZeroChangesNothing)
{
  RollingStage with = on_slope(0.1, true, 0, 0.1);
  with.run(5000);
  RollingStage without = on_slope(0.1, true, 0, 0.1);
  for (int n = 0; n < 5000; ++n) without.step(dt);
  EXPECT_EQ(with.engine.clumps().position[0], without.engine.clumps().position[0]);
  EXPECT_EQ(with.engine.clumps().spin[0], without.engine.clumps().spin[0]);
}

// A drum that turns about +y: the ball rolls in place on its -x side, where the slope is mu_r.
TEST(RollingResistance, BallInADrumStandsAtTheSlopeOfTheCoefficient)
{
  const double mu_r = 0.15, R = 0.1, spin = 6;
  const ContactProperties pair = springs(k, 0.5, 0.2);
  RollingStage stage(pair, g, {mu_r, 0.3});
  TriangleMesh drum;
  const int facets = 1600;
  for (int f = 0; f < facets; ++f) {
    const auto at = [&](int n) {
      const double a = 2 * M_PI * n / facets;
      return Vector3(R * std::cos(a), -0.03, R * std::sin(a));
    };
    append(drum, rectangle(at(f), {0, 0.06, 0}, at(f + 1) - at(f)));
  }
  stage.add_mesh(drum, pair);
  stage.meshes[0].spin = {0, spin, 0};
  const double angle = std::atan(mu_r), m = 2650 * ball(r).volume;
  const Vector3 place =
      (R - r + m * g * std::cos(angle) / k) * Vector3(-std::sin(angle), 0, -std::cos(angle));
  stage.add(0, place, Vector3::Zero(), {0, spin * R / r, 0});
  stage.forces(dt);
  const double start = stage.ledger(dt);
  stage.move(dt);
  double x = 0;
  const int steps = 60000; // 0.3 s: on a slope that is wrong by 0.02 it would be 6 mm away
  for (int n = 0; n < steps; ++n) {
    stage.run(1);
    x += stage.engine.clumps().position[0].x() / steps;
  }
  EXPECT_NEAR(x, place.x(), 0.02 * std::abs(place.x()));
  stage.forces(dt);
  // The wall's work is lost by rolling: mu_r r F_n (spin of the ball less that of the drum).
  const double lost = mu_r * r * m * g * std::cos(angle) * spin * (R / r - 1) * steps * dt;
  EXPECT_NEAR(stage.meshes[0].work(), lost, 0.03 * lost);
  EXPECT_NEAR(stage.engine.energy(dt).contact.friction, lost, 0.03 * lost);
  EXPECT_NEAR(stage.ledger(dt), start, 1e-3 * lost);
}

// Two balls: opposite moments with the rolling radius r1 r2/(r1 + r2), no moment from twisting or
// from turning together, elastic below the limit.
TEST(RollingResistance, MomentOfAPair)
{
  Clumps clumps({ball(r), ball(3 * r)});
  clumps.add(0, 2650, {4 * r, 0, 0}, Quaternion::Identity());
  clumps.add(1, 2650, Vector3::Zero(), Quaternion::Identity());
  std::vector<MeshWall> meshes;
  RollingContact c;
  c.key = {0, 0, 1, 0, 0};
  c.i = 0, c.j = 1;
  c.normal = Vector3::UnitX();
  c.normal_force = 50;
  c.radius_i = r, c.radius_j = 3 * r;
  c.normal_stiffness = k;
  c.rolling.friction = 0.1;
  const double radius = 0.75 * r, limit = 0.1 * radius * 50;
  const double stiffness = 2.25 * k * 0.01 * radius * radius;

  const auto moment_after = [&](const Vector3& spin_i, const Vector3& spin_j, int steps,
                                ContactEnergy& energy) {
    RollingResistance resistance;
    for (const int i : {0, 1}) clumps.lost[i].setZero();
    clumps.step_spin[0] = spin_i, clumps.step_spin[1] = spin_j;
    for (int n = 0; n < steps; ++n) {
      clumps.torque[0].setZero(), clumps.torque[1].setZero();
      energy.elastic = resistance.evaluate({c}, clumps, meshes, 1e-4);
    }
    EXPECT_LT((clumps.torque[0] + clumps.torque[1]).norm(), 1e-18);
    EXPECT_EQ(Vector3(clumps.lost[0]), Vector3(clumps.lost[1])); // half to each
    energy.friction = 2 * clumps.lost.row(Clumps::to_friction)[0];
    return clumps.torque[0];
  };
  ContactEnergy energy;
  const Vector3 rolling(0, 2, 0), twist(7, 0, 0);
  // Elastic: 10 steps of 1e-4 s at 2 rad/s.
  EXPECT_LT(
      (moment_after(rolling, Vector3::Zero(), 10, energy) + stiffness * 0.002 * Vector3::UnitY())
          .norm(),
      1e-12);
  EXPECT_EQ(energy.friction, 0);
  EXPECT_NEAR(energy.elastic, 0.5 * stiffness * 0.002 * 0.002, 1e-15);
  // Full: the work done is stored and lost, nothing else.
  ContactEnergy full;
  EXPECT_LT((moment_after(rolling, Vector3::Zero(), 20000, full) + limit * Vector3::UnitY()).norm(),
            1e-12);
  const double yield = limit / stiffness;
  EXPECT_NEAR(full.friction, limit * (4 - yield), 1e-9);
  EXPECT_NEAR(full.elastic, 0.5 * limit * yield, 1e-9);
  EXPECT_LT(moment_after(rolling, rolling, 100, energy).norm(), 1e-18);
  EXPECT_LT(moment_after(twist, -twist, 100, energy).norm(), 1e-18);
}

// A pile of single balls falls apart and comes to rest, which a constant torque never lets it.
TEST(RollingResistance, LedgerOfAPile)
{
  const ContactProperties pair = springs(k, 0.5, 0.2);
  RollingStage stage(pair, g, {0.25, 0.3});
  stage.add_mesh(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 19, 19), pair);
  for (int n = 0; n < 10; ++n)
    stage.add(0, {0.0061 * (n % 3), 0.0047 * (n % 4), 0.012 + 0.021 * n}, Vector3::Zero());
  stage.forces(dt);
  const double start = stage.ledger(dt);
  double put_in = 0;
  for (int i = 0; i < 10; ++i)
    put_in += stage.engine.clumps().mass[i] * g * stage.engine.clumps().position[i].z();
  stage.run(200000);
  stage.forces(dt);
  EXPECT_NEAR(stage.ledger(dt), start, 1e-3 * put_in);
  for (int i = 0; i < 10; ++i) { // all at rest, but for twisting on the spot, which nothing resists
    const Vector3 spin = stage.engine.clumps().spin[i];
    EXPECT_LT(stage.engine.clumps().velocity[i].norm(), 1e-6);
    EXPECT_LT(Vector3(spin.x(), spin.y(), 0).norm(), 1e-4);
  }
}

TEST(RollingResistance, RemovedClumpsAndWallsAreForgotten)
{
  RollingResistance resistance;
  Clumps clumps({ball(r)});
  for (int n = 0; n < 2; ++n) clumps.add(0, 2650, {0.1 * n, 0, 0}, Quaternion::Identity());
  std::vector<MeshWall> meshes;
  std::vector<RollingContact> list;
  for (int n = 0; n < 2; ++n) {
    RollingContact c;
    c.key = {1, n, 3 * n, 0, 0};
    c.i = n;
    c.normal = Vector3::UnitZ();
    c.normal_force = 1;
    c.radius_i = r;
    c.normal_stiffness = k;
    c.rolling.friction = 0.1;
    list.push_back(c);
    clumps.step_spin[n] = Vector3(0, 1e-3, 0);
  }
  resistance.evaluate(list, clumps, meshes, 1e-3);
  const Vector3 moment = clumps.torque[1];
  ASSERT_GT(moment.norm(), 0);
  resistance.renumber_clumps(clumps.remove({true, false}));
  clumps.step_spin[0].setZero();
  clumps.torque[0].setZero();
  list.erase(list.begin());
  list[0].i = 0, list[0].key[1] = 0;
  resistance.evaluate(list, clumps, meshes, 1e-3);
  EXPECT_EQ(clumps.torque[0], moment);
  resistance.renumber_walls(1, {0, 1, 2, -1});
  clumps.torque[0].setZero();
  resistance.evaluate(list, clumps, meshes, 1e-3);
  EXPECT_EQ(clumps.torque[0], Vector3::Zero());
}

// Stopped, stored and gone on with: every digit is the same.
TEST(RollingResistance, GoesOnFromAStoredState)
{
  const ContactProperties pair = springs(k, 0.5, 0.2);
  RollingStage whole(pair, g, {0.25, 0.3});
  whole.add_mesh(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 190, 190), pair);
  whole.meshes[0].velocity = {0.1, 0, 0};
  whole.meshes[0].spin = {0, 0, 0.7};
  for (int n = 0; n < 6; ++n)
    whole.add(0, {0.0061 * (n % 3), 0.0047 * (n % 4), 0.012 + 0.021 * n}, Vector3::Zero());
  whole.run(15000);
  RollingStage resumed = whole;
  resumed.contacts = MeshContacts();
  resumed.contacts.restore(whole.contacts.contacts());
  resumed.resistance = RollingResistance();
  resumed.resistance.restore(whole.resistance.springs());
  ASSERT_FALSE(whole.resistance.springs().empty());
  for (RollingStage* stage : {&whole, &resumed}) stage->run(5000);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(resumed.engine.clumps().position[i], whole.engine.clumps().position[i]);
    EXPECT_EQ(resumed.engine.clumps().spin[i], whole.engine.clumps().spin[i]);
  }
  EXPECT_EQ(resumed.meshes[0].work(), whole.meshes[0].work());
  EXPECT_EQ(resumed.engine.energy(dt).contact.friction, whole.engine.energy(dt).contact.friction);
}
