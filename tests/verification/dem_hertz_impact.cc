// Normal impacts of elastic spheres, through the engine: tests 1 to 3 of Chung and Ooi, Granular
// Matter 13 (2011) 643-656, against Hertz's theory of impact (Johnson, Contact Mechanics, 1985,
// section 11.4):
//     largest overlap (15 m* v^2/(16 E* sqrt(R*)))^(2/5), duration 2.943275 overlap/v.
// Restitution: with dashpots c ~ overlap^(1/4) it does not depend on velocity or material and
// follows the damping ratio as that of the linear law does (Antypov and Elliott, EPL 94 (2011)
// 50004), in both conventions for the end of a contact; the values without tension are from an
// integration of order 8 of the equation of motion. Fails when a modulus, radius or mass of the
// pair, the exponent of a force or of a dashpot is wrong. Order: 5/2 without dashpots, 1 with them.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
struct Material {
  Elastic elastic;
  double density; // [kg/m3]
};
constexpr Material glass{{48e9, 0.2}, 2800}, limestone{{20e9, 0.25}, 2500};
constexpr Material aluminium{{70e9, 0.33}, 2699}, aluminium_30{{70e9, 0.30}, 2699};
constexpr Material magnesium{{40e9, 0.35}, 1800};
constexpr Material alumina{{380e9, 0.23}, 4000}, cast_iron{{100e9, 0.25}, 7000};
constexpr Elastic rigid{1e30, 0};

struct Rebound {
  Impact impact;
  double restitution;
};

ContactProperties pair_of(const Elastic& a, const Elastic& b, double damping_ratio, bool tension)
{
  ContactProperties pair = hertz_mindlin_pair(a, b, 0, damping_ratio);
  pair.tension = tension;
  return pair;
}

// `v`: of each sphere [m/s]; `expected` duration [s], of which a step is `share`.
Rebound two_spheres(const Material& m, double R, double v, double expected, double share = 1e-4)
{
  Engine engine({ball(R)}, pair_of(m.elastic, m.elastic, 0, false), 0);
  const double dt = share * expected;
  engine.add_clump(0, m.density, {0, 0, R + v * dt / 2}, Quaternion::Identity(), {0, 0, -v});
  engine.add_clump(0, m.density, {0, 0, -R}, Quaternion::Identity(), {0, 0, v});
  const Impact impact = run_impact(engine, dt);
  const std::vector<Vector3> u = {engine.clumps().velocity[0], engine.clumps().velocity[1]};
  return {impact, (u[0].z() - u[1].z()) / (2 * v)};
}

Rebound on_plane(const Material& m, double R, double v, double expected, double damping_ratio = 0,
                 bool tension = true, double share = 1e-4, double phase = 0.5)
{
  Engine engine({ball(R)}, {}, 0);
  engine.add_wall(plane(pair_of(m.elastic, rigid, damping_ratio, tension)));
  const double dt = share * expected;
  engine.add_clump(0, m.density, {0, 0, R + (1 - phase) * v * dt}, Quaternion::Identity(),
                   {0, 0, -v});
  const Impact impact = run_impact(engine, dt);
  return {impact, Vector3(engine.clumps().velocity[0]).z() / v};
}

void compare(const Rebound& r, double force, double overlap, double duration)
{
  // The references have four or five digits.
  EXPECT_NEAR(r.impact.peak_force, force, 2e-4 * force);
  EXPECT_NEAR(r.impact.peak_overlap, overlap, 2e-4 * overlap);
  EXPECT_NEAR(r.impact.duration, duration, 2.5e-4 * duration); // to a step
  EXPECT_NEAR(r.restitution, 1, 1e-8);
  record("force_error", r.impact.peak_force / force - 1);
  record("overlap_error", r.impact.peak_overlap / overlap - 1);
  record("duration_error", r.impact.duration / duration - 1);
}
} // namespace

TEST(HertzImpact, TwoSpheres)
{
  compare(two_spheres(glass, 0.01, 10, 40.34e-6), 10697, 274.11e-6, 40.34e-6);
  compare(two_spheres(limestone, 0.01, 10, 54.20e-6), 7108, 368.30e-6, 54.20e-6);
}

TEST(HertzImpact, SphereOnPlane)
{
  compare(on_plane(aluminium, 0.1, 0.2, 725.5e-6), 11466, 49.30e-6, 725.5e-6);
  compare(on_plane(aluminium_30, 0.1, 0.2, 725.5e-6), 11370, 49.72e-6, 2.943275 * 49.72e-6 / 0.2);
  compare(on_plane(magnesium, 0.1, 0.2, 767.1e-6), 7233, 52.12e-6, 767.1e-6);
}

TEST(HertzImpact, SmallSphereOnPlane)
{
  compare(on_plane(alumina, 0.0025, 3.9, 6.105e-6), 615.35, 8.089e-6, 6.105e-6);
  compare(on_plane(cast_iron, 0.0025, 3.9, 12.97e-6), 506.76, 17.19e-6, 12.97e-6);
}

TEST(HertzImpact, RestitutionIsWhatIsAskedFor)
{
  for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double ratio = damping_ratio_for_restitution(e);
    for (const double v : {3.9, 0.1}) {
      const double slower = std::pow(v / 3.9, -0.2);
      const double a = on_plane(alumina, 0.0025, v, slower * 6.105e-6, ratio).restitution;
      const double b = on_plane(cast_iron, 0.0025, v, slower * 12.97e-6, ratio).restitution;
      EXPECT_NEAR(a, e, 1e-4) << "alumina, " << v << " m/s";
      EXPECT_NEAR(b, e, 1e-4) << "cast iron, " << v << " m/s";
      record("restitution_error", a - e);
      record("restitution_error", b - e);
    }
  }
}

TEST(HertzImpact, RestitutionWithoutTension)
{
  const double table[][3] = {{0.05, 0.854468, 0.858758}, {0.1, 0.729248, 0.744079},
                             {0.2, 0.526621, 0.571740},  {0.3, 0.372326, 0.450975},
                             {0.5, 0.163034, 0.298436},  {0.7, 0.045988, 0.210285},
                             {0.9, 0.001524, 0.155283}};
  for (const auto& [ratio, with, without] : table)
    for (const bool tension : {true, false}) {
      const double e = on_plane(alumina, 0.0025, 3.9, 6.105e-6, ratio, tension).restitution;
      EXPECT_NEAR(e, tension ? with : without, 1e-4) << ratio;
      record("restitution_error", e - (tension ? with : without));
    }
}

// Largest error over when within a step the contact begins. Without dashpots it comes from the
// parts of a step at both ends: they store v^(5/2) dt^(5/2) of energy.
TEST(HertzImpact, Order)
{
  const auto largest_error = [](double ratio, double e, double share) {
    double largest = 0;
    for (double phase = 0.05; phase < 1; phase += 0.1) {
      const Rebound r = on_plane(alumina, 0.0025, 3.9, 6.105e-6, ratio, false, share, phase);
      largest = std::max(largest, std::abs(r.restitution - e));
    }
    return largest;
  };
  for (const double share : {8e-3, 4e-3}) {
    const double elastic = largest_error(0, 1, share) / largest_error(0, 1, share / 2);
    const double damped =
        largest_error(0.2, 0.571740, share) / largest_error(0.2, 0.571740, share / 2);
    EXPECT_NEAR(std::log2(elastic), 2.5, 0.2);
    EXPECT_NEAR(std::log2(damped), 1, 0.2);
  }
}
