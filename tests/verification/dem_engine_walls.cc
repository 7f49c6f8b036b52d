// What the engine itself does with walls of triangles and rolling resistance (the laws behind them
// are tested on their own). It takes a force of a mesh wall or a rolling moment that does not reach
// the clumps, a wall that does not move, work or stored energy that is not booked, or contacts that
// overlap and stable step leave out, to fail.
#include "tests/dem_wall_bench.h"

#include <gtest/gtest.h>

using namespace wall_bench;

namespace
{
constexpr double r = 0.01, k = 1e5, g = 9.81;

double mass()
{
  return 2650 * ball(r).volume;
}

MeshWall floor_of_triangles(const ContactProperties& pair, double height = 0)
{
  MeshWall wall =
      mesh_wall("floor", rectangle({-0.1, -0.1, height}, {0.5, 0, 0}, {0, 0.2, 0}, 20, 8));
  wall.contact = pair;
  return wall;
}

void set_spin(Engine& engine, int i, const Vector3& spin)
{
  Clumps& c = engine.clumps();
  c.spin[i] = c.step_spin[i] = spin;
  c.angular_momentum[i] = c.inertia[i].x() * spin; // balls
}

double residual(Engine& engine, double dt)
{
  engine.compute_forces(0);
  const EngineEnergy e = engine.energy(dt);
  return e.kinetic + e.gravitational + e.contact.elastic + e.contact.friction + e.contact.damping -
         e.wall_work - e.inserted;
}
} // namespace

// A piston that moves at V hits a ball at rest: without damping the ball leaves at 2 V, and the
// piston has worked m (2V)^2/2.
TEST(EngineMeshWall, PistonHitsABallAtRest)
{
  const double dt = 1e-6, V = 0.3;
  Engine engine({ball(r)}, springs(k), 0);
  engine.add_clump(0, 2650, {0, 0, 1.001 * r}, Quaternion::Identity());
  const int w = engine.add_mesh_wall(floor_of_triangles(springs(k)));
  engine.compute_forces(dt);
  engine.mesh_walls()[w].velocity = {0, 0, V};
  double deepest = 0;
  for (int n = 0; n < 4000; ++n) {
    engine.step(dt);
    deepest = std::max(deepest, engine.largest_overlap());
  }
  EXPECT_NEAR(engine.mesh_walls()[w].centre.z(), 4000 * dt * V, 1e-12);
  EXPECT_NEAR(engine.clumps().velocity[0].z(), 2 * V, 1e-4 * V);
  EXPECT_NEAR(deepest, V * std::sqrt(mass() / k), 1e-3 * deepest);
  EXPECT_NEAR(engine.energy(dt).wall_work, 2 * mass() * V * V, 1e-4 * mass() * V * V);
  EXPECT_NEAR(residual(engine, dt), 0, 1e-6 * mass() * V * V);
}

// Put in with an overlap d, a wall stores k d^2/2 that nobody worked for: booked as inserted, and
// the ball leaves with it. Taken away instead, the ball takes it along.
TEST(EngineMeshWall, OverlapAtTheStartIsBooked)
{
  const double dt = 1e-6, depth = 1e-4, stored = 0.5 * k * depth * depth;
  for (const bool remove : {false, true}) {
    Engine engine({ball(r)}, springs(k), 0);
    engine.add_clump(0, 2650, {0, 0, r - depth}, Quaternion::Identity());
    engine.add_mesh_wall(floor_of_triangles(springs(k)));
    EXPECT_NEAR(engine.energy(dt).inserted, stored, 1e-9 * stored);
    engine.compute_forces(dt);
    EXPECT_NEAR(engine.energy(dt).contact.elastic, stored, 1e-9 * stored);
    EXPECT_NEAR(engine.largest_overlap(), depth, 1e-9 * depth);
    if (remove) {
      engine.remove_clumps({true});
      EXPECT_NEAR(engine.energy(dt).inserted, 0, 1e-9 * stored);
      continue;
    }
    for (int n = 0; n < 4000; ++n) engine.step(dt);
    EXPECT_NEAR(engine.clumps().velocity[0].z(), depth * std::sqrt(k / mass()),
                1e-4 * depth * std::sqrt(k / mass()));
  }
}

// Of one contact, documented at Engine::stable_step: 2 / sqrt(2 k (1/m + r^2/I)), r the arm from
// the centre to the middle of the overlap.
TEST(EngineMeshWall, LimitsTheStableStep)
{
  const double depth = 1e-4, arm = r - 0.5 * depth;
  Engine engine({ball(r)}, springs(k), 0);
  engine.add_clump(0, 2650, {0.003, 0.002, r - depth}, Quaternion::Identity());
  engine.add_mesh_wall(floor_of_triangles(springs(k)));
  engine.compute_forces(1e-6);
  const double mobility = 1 / mass() + arm * arm / (0.4 * mass() * r * r);
  const double exact = 2 / std::sqrt(2 * k * mobility);
  EXPECT_NEAR(engine.stable_step().step, exact, 0.02 * exact);
  EXPECT_EQ(engine.stable_step().contacts, 1);
}

// A ball that rolls without slip on a plane or on triangles slows down by (5/7) mu_r g; what it
// loses has gone into friction.
TEST(EngineRolling, BallSlowsDownOnWallsOfBothKinds)
{
  const double mu_r = 0.08, v0 = 0.2, dt = 5e-6, exact = 5. / 7 * mu_r * g;
  for (const bool triangles : {false, true}) {
    const ContactProperties pair = springs(k, 0.6, 0.3);
    Engine engine({ball(r)}, pair, g);
    engine.add_clump(0, 2650, {0, 0, r - mass() * g / k}, Quaternion::Identity(), {v0, 0, 0});
    set_spin(engine, 0, {0, v0 / r, 0});
    if (triangles)
      engine.add_mesh_wall(floor_of_triangles(pair));
    else
      engine.add_wall(rectangle_wall({-0.1, -0.1, 0}, {0.5, 0, 0}, {0, 0.2, 0}, pair));
    engine.set_rolling({mu_r, 0.3});
    for (int n = 0; n < 10000; ++n) engine.step(dt);
    const double early = engine.clumps().velocity[0].x();
    engine.compute_forces(0);
    const double lost = engine.energy(dt).contact.friction;
    for (int n = 0; n < 20000; ++n) engine.step(dt);
    const double late = engine.clumps().velocity[0].x();
    engine.compute_forces(0);
    EXPECT_NEAR((early - late) / (20000 * dt), exact, 2e-3 * exact) << triangles;
    EXPECT_NEAR(engine.clumps().spin[0].y(), late / r, 2e-3 * late / r) << triangles;
    const double kinetic = 0.7 * mass() * (early * early - late * late);
    EXPECT_NEAR(engine.energy(dt).contact.friction - lost, kinetic, 4e-3 * kinetic) << triangles;
  }
}

// Two balls squeezed between two smooth planes turn against each other like gears: nothing slides
// between them, and each is braked by mu_r (r/2) N at the other ball and by mu_r r N at its plane.
TEST(EngineRolling, BallsThatTurnLikeGearsSlowDown)
{
  const double mu_r = 0.1, dt = 1e-6, spin = 200, depth = 1e-5, force = k * depth;
  Engine engine({ball(r)}, springs(k, 0.6), 0);
  const double x = r - 0.5 * depth; // every contact overlaps by `depth`
  engine.add_clump(0, 2650, {-x, 0, 0}, Quaternion::Identity());
  engine.add_clump(0, 2650, {x, 0, 0}, Quaternion::Identity());
  for (const double side : {-1., 1.})
    engine.add_wall(rectangle_wall({side * (2 * r - 1.5 * depth), -0.1, -0.1}, {0, 0.2, 0},
                                   {0, 0, 0.2}, springs(k)));
  set_spin(engine, 0, {0, spin, 0});
  set_spin(engine, 1, {0, -spin, 0});
  engine.set_rolling({mu_r, 0});
  const double inertia = 0.4 * mass() * r * r, brake = mu_r * 1.5 * r * force / inertia;
  const int steps = static_cast<int>(0.25 * spin / brake / dt);
  for (int n = 0; n < steps; ++n) engine.step(dt);
  const double early = engine.clumps().spin[0].y();
  for (int n = 0; n < steps; ++n) engine.step(dt);
  const double late = engine.clumps().spin[0].y();
  EXPECT_NEAR((early - late) / (steps * dt), brake, 1e-3 * brake);
  EXPECT_NEAR(engine.clumps().spin[1].y(), -late, 1e-9 * spin);
  EXPECT_LT(engine.clumps().position[0].z(), 1e-9);
}
