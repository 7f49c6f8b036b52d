// Impacts of clumps, through the engine.
//
// A dumb-bell hits a plane with one of its two spheres, its rod at an angle. Let n be the normal, t
// the direction in which the sphere slides (in the
// plane of n and the rod, so that it stays), r the arm of the contact, and
//     M f = f/m + I^-1 (r x f) x r   (velocity at the contact per unit impulse).
// With gross slip the force is f (n - mu t) all the time, so the overlap is an oscillator of mass
// m* = 1/(n.M(n - mu t)): the impulse is (1 + e) v_n m* (n - mu t), with e = 1 without dashpots.
// With them, c = 2 b sqrt(k m) of the clump's mass m, so e = exp(-pi B/sqrt(1 - B^2)), B = b
// sqrt(m*/m), where the contact ends at zero overlap. The rod turns by 1e-4 rad meanwhile, what is
// left of the difference.
//
// A ball of n coincident spheres is the ball itself: with stiffness/n, and damping ratio/sqrt(n),
// as a dashpot goes with the root of the stiffness, the forces add up to the same. Equal to
// rounding. Fails when forces, torques or histories of members mix or an arm is wrong.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double r = 0.005, half_length = 0.02, density = 2600, v = 0.5, k = 1e9;

ClumpShape dumb_bell() // along x
{
  ClumpShape shape;
  for (const int side : {-1, 1}) shape.spheres.push_back({{side * half_length, 0, 0}, r});
  const double one = ball(r).volume;
  shape.volume = 2 * one;
  const double across = 2 * one * (0.4 * r * r + half_length * half_length);
  shape.unit_inertia = {0.8 * one * r * r, across, across};
  return shape;
}

void hit(double angle, double friction, double damping_ratio, int slide = 0)
{
  const ClumpShape shape = dumb_bell();
  ContactProperties contact = smooth_contact(k, damping_ratio, true);
  contact.friction = friction;
  Engine engine({shape}, {}, 0);
  engine.add_wall(plane(contact));
  const double m = density * shape.volume, dt = 2e-4 * std::sqrt(m / k);
  // Turned about z as well, so that no axis of the world is special.
  const Quaternion lean(Eigen::AngleAxisd(0.7, Vector3::UnitZ()) *
                        Eigen::AngleAxisd(-angle, Vector3::UnitY()));
  const Vector3 n = Vector3::UnitZ(), along = Vector3(std::cos(0.7), std::sin(0.7), 0);
  const Vector3 low = lean * Vector3(-half_length, 0, 0), arm = low - r * n;
  const Vector3 start = -v * n + 5 * slide * v * along, t = slide * along;
  engine.add_clump(0, density, {0, 0, -arm.z() + 0.5 * v * dt}, lean, start);
  run_impact(engine, dt);

  const Matrix3 axes = lean.toRotationMatrix();
  const Matrix3 inertia = density * axes * shape.unit_inertia.asDiagonal() * axes.transpose();
  const Vector3 force = n - friction * t;
  const Vector3 turn = inertia.inverse() * arm.cross(force);
  const double mass = 1 / n.dot(force / m + turn.cross(arm)),
               b = damping_ratio * std::sqrt(m / mass);
  const double e = std::exp(-M_PI * b / std::sqrt(1 - b * b));
  const double impulse = (1 + e) * v * mass;
  const Vector3 kick = engine.clumps().velocity[0] - start, spin = engine.clumps().spin[0];
  EXPECT_LT((kick - impulse / m * force).norm(), 1e-4 * kick.norm()) << angle << " " << friction;
  EXPECT_LT((spin - impulse * turn).norm(), 1e-4 * spin.norm()) << angle << " " << friction;
  record("velocity_error", (kick - impulse / m * force).norm() / kick.norm());
  record("spin_error", (spin - impulse * turn).norm() / spin.norm());
}
} // namespace

TEST(ClumpImpact, DumbBellHitsWithOneEnd)
{
  for (const double angle : {0.2, 0.6, 1.0, 1.4}) hit(angle, 0, 0);
}

TEST(ClumpImpact, DumbBellHitsWithOneEndAndSlips)
{
  for (const double angle : {0.2, 0.6, 1.0, 1.4})
    for (const int slide : {-1, 1}) hit(angle, 0.3, 0, slide);
}

TEST(ClumpImpact, DumbBellHitsWithOneEndAgainstADashpot)
{
  for (const double angle : {0.2, 0.6, 1.0, 1.4}) hit(angle, 0, 0.2);
}

// Both ends at once: twice the stiffness on the whole mass, no spin.
TEST(ClumpImpact, DumbBellLandsFlat)
{
  const ClumpShape shape = dumb_bell();
  Engine engine({shape}, {}, 0);
  engine.add_wall(plane(smooth_contact(k, 0, false)));
  const double duration = M_PI * std::sqrt(density * shape.volume / (2 * k)), dt = 1e-4 * duration;
  engine.add_clump(0, density, {0, 0, r + 0.5 * v * dt}, Quaternion::Identity(), {0, 0, -v});
  const Impact impact = run_impact(engine, dt);
  EXPECT_NEAR(impact.duration, duration, 2e-4 * duration);
  EXPECT_NEAR(engine.clumps().velocity[0].z(), v, 1e-6 * v);
  EXPECT_LT(engine.clumps().spin[0].norm(), 1e-9 * v / r);
}

namespace
{
// A ball bounces on a rough plane, spinning, and another one falls on it. Every ball is made of
// `copies` coincident spheres.
Engine bouncing_balls(int copies, double dt, int steps)
{
  ClumpShape shape = ball(0.01);
  shape.spheres.resize(copies, shape.spheres[0]);
  const auto contact = [](int contacts) {
    ContactProperties pair = smooth_contact(1e6 / contacts, 0.1 / std::sqrt(contacts), false);
    pair.tangential_stiffness = 4e5 / contacts;
    pair.friction = 0.4;
    return pair;
  };
  Engine engine({shape}, contact(copies * copies), 9.81);
  engine.add_wall(plane(contact(copies)));
  engine.add_clump(0, density, {0, 0, 0.012}, Quaternion::Identity(), {0.3, -0.1, -0.5});
  engine.add_clump(0, density, {0.005, 0, 0.04}, Quaternion::Identity(), {0.3, -0.1, -1});
  set_spin(engine, 0, {10, 20, 30});
  for (int n = 0; n < steps; ++n) engine.step(dt);
  return engine;
}
} // namespace

TEST(ClumpImpact, CoincidentSpheresAreOneSphere)
{
  const double dt = 2e-6;
  const int steps = 50000;
  const Engine one = bouncing_balls(1, dt, steps);
  EXPECT_GT(one.energy(dt).contact.friction, 0);
  EXPECT_GT(one.energy(dt).contact.damping, 0);
  for (const int copies : {2, 4, 9}) {
    const Engine many = bouncing_balls(copies, dt, steps);
    for (const int i : {0, 1}) {
      const double x = (many.clumps().position[i] - one.clumps().position[i]).norm();
      const double w = (many.clumps().spin[i] - one.clumps().spin[i]).norm();
      EXPECT_LT(x, 1e-10) << copies << " copies, clump " << i;
      EXPECT_LT(w, 1e-7) << copies << " copies, clump " << i;
      record("position_difference", x);
    }
    EXPECT_NEAR(many.energy(dt).contact.friction, one.energy(dt).contact.friction, 1e-10);
    EXPECT_NEAR(many.energy(dt).contact.damping, one.energy(dt).contact.damping, 1e-10);
  }
}
