// Impacts with spin and tangential velocity, through the engine: the set-ups of tests 5 to 8 of
// Chung and Ooi, Granular Matter 13 (2011) 643-656, against impulse theory.
//
// u: tangential velocity of the surfaces at the contact, e: normal restitution, J: impulses. Gross
// slip, for u large: J_t = mu J_n along -u, J_n = (1 + e) m* v_n, change of spin J_t R/I. Stick:
// where k_t = 2/7 k_n, the springs of solid spheres swing in time, because the surfaces are 7/2
// times as mobile along the contact as across it. An elastic contact then either slips all the time
// (u > 7/2 mu v_n) or never, and gives u back reversed (Walton's law with beta_0 = 1):
//     J_t = min(mu J_n, 2 u/(7/2 (1/m1 + 1/m2))).
// Fails when the cone, the tangential spring, a lever arm or a sign of a spin is wrong. What is
// left: overlap over radius (1e-4) in the lever arms, and first order in the step.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double R = 0.01, density = 2600, mu = 0.3, v_n = 0.2, dt = 1e-8, tolerance = 2e-4;

ContactProperties rough_contact(double damping_ratio)
{
  ContactProperties pair = smooth_contact(1e8, damping_ratio, false);
  pair.tangential_stiffness = 2. / 7 * pair.normal_stiffness;
  pair.friction = mu;
  return pair;
}

struct Motion {
  Vector3 velocity, spin;
};

const ContactProperties elastic = rough_contact(0);
const Vector3 still = Vector3::Zero(), z = Vector3::UnitZ();

// Body 0 comes along -z; body 1 lies below it: another sphere, or a plane if there is one radius
// only. Checks the motion after the impact against impulse theory and returns it.
std::vector<Motion> impact(const std::vector<double>& radii, const std::vector<Motion>& before,
                           const ContactProperties& pair, bool stick_counts)
{
  std::vector<ClumpShape> shapes;
  for (const double radius : radii) shapes.push_back(ball(radius));
  const int n = shapes.size();
  Engine engine(shapes, pair, 0);
  if (n == 1) engine.add_wall(plane(pair));
  const double gap = 0.5 * v_n * dt, height[] = {radii[0] + gap, n == 2 ? -radii[1] : 0};
  for (int i = 0; i < n; ++i) {
    engine.add_clump(i, density, {0, 0, height[i]}, Quaternion::Identity(), before[i].velocity);
    set_spin(engine, i, before[i].spin);
  }
  run_impact(engine, dt);
  const Clumps& clumps = engine.clumps();

  const double mobility = 1 / clumps.mass[0] + (n == 2 ? 1 / clumps.mass[1] : 0);
  Vector3 u = before[0].velocity - radii[0] * before[0].spin.cross(z);
  if (n == 2) u -= before[1].velocity + radii[1] * before[1].spin.cross(z);
  const double approach = -u.z();
  u.z() = 0;
  const double parting = clumps.velocity[0].z() - (n == 2 ? clumps.velocity[1].z() : 0);
  const double normal_impulse = (approach + parting) / mobility;
  double slip = mu * normal_impulse;
  if (stick_counts) slip = std::min(slip, 2 * u.norm() / (3.5 * mobility));
  const Vector3 impulse = normal_impulse * z - slip * u.stableNormalized();

  std::vector<Motion> after(n);
  for (int i = 0; i < n; ++i) {
    const double sign = i == 0 ? 1 : -1;
    after[i].velocity = clumps.velocity[i];
    after[i].spin = clumps.spin[i];
    const Vector3 kick = after[i].velocity - before[i].velocity;
    const Vector3 turn = radii[i] * (after[i].spin - before[i].spin);
    const Vector3 wanted_kick = sign / clumps.mass[i] * impulse;
    // Both arms point to the contact: against the impulse on either body.
    const Vector3 wanted_turn = -2.5 / clumps.mass[i] * z.cross(impulse);
    EXPECT_LT((kick - wanted_kick).norm(), tolerance * wanted_kick.norm()) << u.norm();
    EXPECT_LT((turn - wanted_turn).norm(), tolerance * 2.5 * wanted_kick.norm()) << u.norm();
    record("impulse_error", (kick - wanted_kick).norm() / wanted_kick.norm());
    record("spin_error", (turn - wanted_turn).norm() / (2.5 * wanted_kick.norm()));
  }
  return after;
}

const std::vector<double> tangents = {0.1, 0.5, 0.9, 1.1, 2, 4, 8}; // of u: u/(7/2 mu v_n)
constexpr double limit = 3.5 * mu * v_n;                            // slips all the time above
} // namespace

// Test 5: sphere on plane, tangential velocity varied.
TEST(SpinningImpact, TangentialVelocityVaried)
{
  for (const double t : tangents)
    impact({R}, {{Vector3(0.6 * t * limit, 0.8 * t * limit, -v_n), still}}, elastic, true);
}

// Test 6: sphere on plane, spin varied; the part along the normal stays.
TEST(SpinningImpact, SpinVaried)
{
  for (const double t : tangents) {
    const Vector3 spin = t * limit / R * Vector3(-0.8, 0.6, 0.3);
    const Motion after = impact({R}, {{-v_n * z, spin}}, elastic, true)[0];
    EXPECT_NEAR(after.spin.z(), spin.z(), 1e-9 * std::abs(spin.z()));
  }
}

// Sphere on plane with dashpots: gross slip follows the restitution that there is.
TEST(SpinningImpact, GrossSlipWithDashpots)
{
  for (const double ratio : {0.05, 0.2, 0.5})
    for (const double t : {2.5, 5., 10.}) {
      impact({R}, {{Vector3(t * limit, 0, -v_n), still}}, rough_contact(ratio), false);
      impact({R}, {{-v_n * z, Vector3(0, t * limit / R, 0)}}, rough_contact(ratio), false);
    }
}

// The same with Hertz and Mindlin's law: glass, whose contact takes twenty times as long.
TEST(SpinningImpact, GrossSlipOfElasticSpheres)
{
  for (const double ratio : {0., 0.1}) {
    const ContactProperties glass = hertz_mindlin_pair({48e9, 0.2}, {48e9, 0.2}, mu, ratio);
    for (const double t : {2.5, 5., 10.}) {
      const Vector3 spin(0, t * limit / R, 0);
      impact({R}, {{Vector3(t * limit, 0, -v_n), still}}, glass, false);
      impact({R}, {{-v_n * z, spin}}, glass, false);
      impact({R, R}, {{-0.5 * v_n * z, 0.5 * spin}, {0.5 * v_n * z, 0.5 * spin}}, glass, false);
      impact({R, 3 * R}, {{-v_n * z, spin}, {still, still}}, glass, false);
    }
  }
}

// Test 7: two equal spheres. Surfaces that move alike (opposite spins) do not notice each other;
// equal spins rub.
TEST(SpinningImpact, TwoEqualSpheres)
{
  const Vector3 fall = -0.5 * v_n * z;
  for (const double t : tangents) {
    const Vector3 spin(0, 0.5 * t * limit / R, 0);
    impact({R, R}, {{fall, spin}, {-fall, spin}}, elastic, true);
    const auto after = impact({R, R}, {{fall, spin}, {-fall, -spin}}, elastic, true);
    EXPECT_LT((after[0].spin - spin).norm(), 1e-9 * spin.norm());
    EXPECT_LT((after[1].spin + spin).norm(), 1e-9 * spin.norm());
  }
}

// Test 8: two different spheres, spin varied.
TEST(SpinningImpact, TwoDifferentSpheres)
{
  for (const double t : tangents) {
    const Vector3 spin = t * limit / R * Vector3(0.6, -0.8, 0);
    impact({R, 3 * R}, {{-v_n * z, spin}, {still, still}}, elastic, true);
    impact({3 * R, R}, {{-v_n * z, spin / 3}, {still, 0.5 * spin}}, elastic, true);
  }
}
