// Local damping (Cundall 1987) of the engine: each component of the unbalanced force F becomes
// F - share |F| sign(v). On a linear spring of stiffness k the way in is then that of an oscillator
// with k (1 + share), the way out with k (1 - share), so both have closed forms. It takes another
// share, a sign, a weight or a torque that is left out, damping of stones that touch nothing, or
// work that is not booked, to fail.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double radius = 0.01, stiffness = 1e5, density = 2650;

double ball_mass()
{
  return density * ball(radius).volume;
}

double stored_and_lost(const EngineEnergy& e)
{
  return e.kinetic + e.gravitational + e.contact.elastic + e.local_damping - e.inserted;
}

// An engine with one ball over a plane at z = 0, its centre at `height` [m].
Engine ball_over_plane(double height, double speed, double gravity, double share, bool tension)
{
  Engine engine({ball(radius)}, smooth_contact(stiffness, 0, tension), gravity);
  engine.add_clump(0, density, {0, 0, height}, Quaternion::Identity(), {0, 0, speed});
  engine.add_wall(plane(smooth_contact(stiffness, 0, tension)));
  engine.set_local_damping(share);
  return engine;
}
} // namespace

// Without gravity: speed lost and gained on a spring of k (1 + share) and k (1 - share), so the
// restitution is sqrt((1 - share)/(1 + share)), the deepest overlap v sqrt(m/(k (1 + share))), and
// the contact lasts a quarter of a period of each.
TEST(LocalDamping, RestitutionOfAnImpact)
{
  const double v = 0.5, mass = ball_mass();
  for (const double share : {0., 0.3, 0.7}) {
    const double period = 2 * M_PI * std::sqrt(mass / stiffness), dt = period / 20000;
    Engine engine = ball_over_plane(radius + 2 * v * dt, -v, 0, share, false);
    const Impact impact = run_impact(engine, dt);
    engine.compute_forces(dt);
    const EngineEnergy end = engine.energy(dt);
    const double restitution = std::sqrt((1 - share) / (1 + share));
    const double in = 1 / std::sqrt(1 + share), out = 1 / std::sqrt(1 - share);
    EXPECT_NEAR(engine.clumps().velocity[0].z(), restitution * v, 1e-3 * v) << share;
    EXPECT_NEAR(impact.peak_overlap, v * std::sqrt(mass / stiffness) * in,
                1e-3 * impact.peak_overlap);
    EXPECT_NEAR(impact.duration, 0.25 * period * (in + out), 1e-3 * period) << share;
    const double lost = 0.5 * mass * v * v * 2 * share / (1 + share);
    EXPECT_NEAR(end.local_damping, lost, 1e-3 * 0.5 * mass * v * v) << share;
    EXPECT_NEAR(stored_and_lost(end), 0, 1e-6 * 0.5 * mass * v * v) << share;
  }
}

// With gravity: the unbalanced force vanishes where the spring carries the weight, and the ball
// swings about that place; every half swing is smaller by sqrt((1 - share)/(1 + share)).
TEST(LocalDamping, SwingAboutRestShrinksByItsShare)
{
  const double g = 9.81, mass = ball_mass(), sag = mass * g / stiffness, share = 0.2;
  const double dt = 2 * M_PI * std::sqrt(mass / stiffness) / 20000;
  Engine engine = ball_over_plane(radius - 1.9 * sag, 0, g, share, false);
  std::vector<double> extremes = {-0.9 * sag};
  double before = 0, lost = 0;
  while (extremes.size() < 7) {
    engine.step(dt);
    const double speed = engine.clumps().velocity[0].z();
    if (before * speed < 0) extremes.push_back(engine.clumps().position[0].z() - radius + sag);
    before = speed;
    const double lost_now = engine.energy(dt).local_damping;
    ASSERT_GE(lost_now, lost - 1e-6 * stiffness * sag * sag); // it never gives
    lost = lost_now;
  }
  const double ratio = std::sqrt((1 - share) / (1 + share));
  for (std::size_t n = 1; n < extremes.size(); ++n)
    EXPECT_NEAR(extremes[n], -ratio * extremes[n - 1], 2e-3 * sag) << n;
  // All that is missing of the first swing's energy is booked.
  const double first = extremes.front(), last = extremes.back();
  EXPECT_NEAR(lost, 0.5 * stiffness * (first * first - last * last),
              2e-3 * 0.5 * stiffness * first * first);
}

// A stone that touches nothing falls freely.
TEST(LocalDamping, FreeFallIsFree)
{
  const double g = 9.81, dt = 1e-4;
  Engine engine = ball_over_plane(1, 0, g, 0.7, false);
  for (int n = 0; n < 1000; ++n) engine.step(dt);
  EXPECT_NEAR(engine.clumps().velocity[0].z(), -g * 1000 * dt, 1e-12);
  engine.compute_forces(dt);
  EXPECT_EQ(engine.energy(dt).local_damping, 0);
}

// A constant force and torque that somebody else kicks in, first against the motion and then with
// it: the ball is slowed down by F (1 + share) and sped up again by F (1 - share), turned likewise,
// and what was lost is share F times the length of the way, there and back.
TEST(LocalDamping, ForcesOfOthersCount)
{
  const double share = 0.4, force = 0.3, torque = 5e-4, v = 0.2, w = 15, dt = 1e-6;
  Engine engine({ball(radius)}, smooth_contact(stiffness, 0, false), 0);
  engine.add_clump(0, density, Vector3::Zero(), Quaternion::Identity(), {-v, 0, 0});
  Clumps& clumps = engine.clumps();
  set_spin(engine, 0, {0, -w, 0});
  engine.set_local_damping(share);
  VectorField forces, torques;
  forces.resize(1), torques.resize(1);
  forces[0] = Vector3(force, 0, 0), torques[0] = Vector3(0, torque, 0);
  const double mass = clumps.mass[0], inertia = clumps.inertia[0].x();
  const int steps = 40000;
  for (int n = 0; n < steps; ++n) {
    engine.compute_forces(dt);
    engine.kick_all(dt, &forces, &torques);
    clumps.velocity[0] += dt * clumps.inverse_mass[0] * forces[0];
    clumps.angular_momentum[0] += dt * torques[0];
    engine.drift_all(dt);
  }
  const double time = steps * dt;
  // Speed and way at the end of a motion that starts against the push, with slow-down a and
  // speed-up b.
  const auto motion = [time](double start, double a, double b) {
    const double turn = start / a, after = time - turn;
    EXPECT_GT(after, 0.2 * time);
    return std::make_pair(b * after, 0.5 * start * turn + 0.5 * b * after * after);
  };
  const auto [speed, way] = motion(v, force * (1 + share) / mass, force * (1 - share) / mass);
  const auto [spin, angle] =
      motion(w, torque * (1 + share) / inertia, torque * (1 - share) / inertia);
  EXPECT_NEAR(clumps.velocity[0].x(), speed, 1e-3 * v);
  EXPECT_NEAR(clumps.spin[0].y(), spin, 1e-3 * w);
  const double lost = share * (force * way + torque * angle);
  EXPECT_NEAR(engine.energy(dt).local_damping, lost, 1e-3 * lost);
}
