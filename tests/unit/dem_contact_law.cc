// The linear contact law against closed forms. Fails when the dashpot, the end of the contact, the
// Coulomb cone, the tangential history or the energy bookkeeping is wrong.
#include "dem/contacts/single_contact.h"

#include <gtest/gtest.h>

using namespace interlock::dem;

namespace
{
struct Impact {
  double restitution = 0, duration = 0, largest_overlap = 0, dissipated = 0; // [-], [s], [m], [J]
};

// A body of mass m hits a wall at 1 m/s, leapfrog with `dt`.
Impact impact(double damping_ratio, bool tension, double m, double k, double dt)
{
  ContactProperties pair;
  pair.normal_stiffness = k;
  pair.tangential_stiffness = k;
  pair.damping_ratio = damping_ratio;
  pair.tension = tension;
  ContactHistory history;
  ContactEnergy energy;
  const Vector3 normal(0, 0, 1);
  Impact result;
  double x = 0.5 * dt, v = -1; // x: height of the surface above the wall, first step half way in
  for (int n = 0; n < 10000000; ++n) {
    x += dt * v;
    if (x >= 0) break;
    energy.elastic = 0;
    const Vector3 force =
        linear_contact_force(pair, m, -x, normal, Vector3(0, 0, v), dt, history, energy);
    if (force.z() != 0) result.duration += dt;
    v += dt * force.z() / m;
    result.largest_overlap = std::max(result.largest_overlap, -x);
  }
  end_contact(pair, x, Vector3(0, 0, v), dt, history, energy);
  result.restitution = v;
  result.dissipated = energy.damping;
  return result;
}

constexpr double m = 0.08, k = 6e7;
const double w0 = std::sqrt(k / m), fine = 1e-4 / w0;
} // namespace

TEST(ContactLaw, ElasticImpactHasTheExactTimeAndOverlap)
{
  const Impact elastic = impact(0, false, m, k, fine);
  EXPECT_NEAR(elastic.duration, M_PI / w0, 1e-3 * M_PI / w0);
  EXPECT_NEAR(elastic.largest_overlap, std::sqrt(m / k), 1e-5 * std::sqrt(m / k));
  EXPECT_NEAR(elastic.restitution, 1, 1e-6);
}

// Contact time and restitution in both conventions, Schwager and Poeschel (2007). Columns: damping
// ratio, restitution with and without tension, duration times w0 with and without.
TEST(ContactLaw, RestitutionInBothConventions)
{
  const double table[][5] = {{0.05, 0.854468, 0.858758, 3.14553, 3.04536},
                             {0.1, 0.729248, 0.744079, 3.15742, 2.95608},
                             {0.3, 0.372326, 0.450975, 3.29328, 2.65448},
                             {0.7, 0.045988, 0.210285, 4.39911, 2.22756}};
  for (const auto& row : table) {
    const Impact with = impact(row[0], true, m, k, fine),
                 without = impact(row[0], false, m, k, fine);
    EXPECT_NEAR(with.restitution, row[1], 3e-4) << "damping ratio " << row[0];
    EXPECT_NEAR(without.restitution, row[2], 3e-4) << "damping ratio " << row[0];
    EXPECT_NEAR(with.duration * w0, row[3], 1e-3 * row[3]) << "damping ratio " << row[0];
    EXPECT_NEAR(without.duration * w0, row[4], 1e-3 * row[4]) << "damping ratio " << row[0];
  }
}

TEST(ContactLaw, DashpotEnergyIsWhatTheBodyLost)
{
  // At a step as coarse as in a run: 30 steps in the impact. First order bookkeeping would err by 3
  // %.
  const Impact coarse = impact(0.2, false, m, k, 0.1 / w0);
  const double lost = 0.5 * m * (1 - coarse.restitution * coarse.restitution);
  EXPECT_NEAR(coarse.dissipated, lost, 5e-3 * lost);
}

// A block under its weight slides to rest in t = v0/(mu g), x = v0^2/(2 mu g); friction takes all
// of its energy.
TEST(ContactLaw, SlidingBlockStops)
{
  const double mu = 0.4, g = 9.81, v0 = 0.5, mass = 0.1, dt = 1e-5;
  ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 1e6;
  pair.friction = mu;
  const double overlap = mass * g / pair.normal_stiffness;
  ContactHistory history;
  ContactEnergy energy;
  double x = 0, v = v0, t = 0;
  for (; v > 0; t += dt) {
    x += dt * v;
    energy.elastic = 0;
    v += dt / mass *
         linear_contact_force(pair, mass, overlap, {0, 0, 1}, {v, 0, 0}, dt, history, energy).x();
  }
  EXPECT_NEAR(t, v0 / (mu * g), 5e-3 * t);
  EXPECT_NEAR(x, v0 * v0 / (2 * mu * g), 5e-3 * x);
  EXPECT_NEAR(energy.friction, 0.5 * mass * v0 * v0, 5e-3 * 0.5 * mass * v0 * v0);
}

// Prescribed sawtooth u(t) of amplitude u_a > mu N/k_t: F = min(k_t u, mu N) with history, area of
// the closed loop 4 mu N (u_a - mu N/k_t).
TEST(ContactLaw, StickSlipHysteresis)
{
  ContactProperties pair;
  pair.normal_stiffness = 1e7;
  pair.tangential_stiffness = 2e6;
  pair.friction = 0.5;
  const double overlap = 1e-5, limit = pair.friction * pair.normal_stiffness * overlap;
  const double amplitude = 3 * limit / pair.tangential_stiffness, dt = 1e-3;
  const int steps = 4000; // of a quarter of a loop
  ContactHistory history;
  ContactEnergy energy;
  double u = 0, area = 0, old_force = 0, friction_before = 0, largest = 0;
  auto move = [&](double target, int n) {
    const double velocity = (target - u) / (n * dt);
    for (int i = 0; i < n; ++i) {
      u += velocity * dt;
      energy.elastic = 0;
      const double force =
          -linear_contact_force(pair, 1, overlap, {0, 0, 1}, {velocity, 0, 0}, dt, history, energy)
               .x();
      area += 0.5 * (force + old_force) * velocity * dt;
      old_force = force;
      largest = std::max(largest, std::abs(force));
    }
  };
  move(amplitude, steps);
  move(-amplitude, 2 * steps);
  area = 0, friction_before = energy.friction;
  move(amplitude, 2 * steps);
  move(-amplitude, 2 * steps);
  const double exact = 4 * limit * (amplitude - limit / pair.tangential_stiffness);
  EXPECT_NEAR(largest, limit, 1e-12 * limit);
  EXPECT_NEAR(area, exact, 1e-3 * exact);
  EXPECT_NEAR(energy.friction - friction_before, exact, 1e-3 * exact);
}

// A stuck, loaded pair turned rigidly through 2 pi about any axis: the spring turns with it.
TEST(ContactLaw, SpringTurnsWithTheContact)
{
  const int steps = 100000;
  for (const Vector3& axis :
       {Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(1, -2, 0.5).normalized()}) {
    Vector3 spring(1e-5, 2e-5, 0);
    const Vector3 first = spring;
    const double angle = 2 * M_PI / steps;
    for (int n = 1; n <= steps; ++n) {
      const Vector3 normal = Eigen::AngleAxisd(n * angle, axis) * Vector3(0, 0, 1);
      rotate_spring(spring, normal, angle * axis);
      const Vector3 exact = Eigen::AngleAxisd(n * angle, axis) * first;
      ASSERT_LT((spring - exact).norm(), 1e-3 * first.norm()) << "step " << n;
    }
    EXPECT_NEAR(spring.norm(), first.norm(), 1e-10 * first.norm()); // rounding of 1e5 steps
  }
}
