// Head-on impacts through the engine: the linear spring and dashpot against its exact solution.
//
// With w0 = sqrt(k/m*) and b = c/(2 sqrt(k m*)):
//   elastic: duration pi/w0, largest overlap v sqrt(m*/k), largest force v sqrt(k m*);
//   ends at zero overlap: e = exp(-pi b/sqrt(1 - b^2)), duration pi/(w0 sqrt(1 - b^2));
//   ends at zero force: Schwager and Poeschel, Granular Matter 9 (2007) 465-469.
// Order: 2 without dashpots, 1 with them (a dashpot sees the velocity half a step ago, and its
// force jumps at the first touch). Fails when the reduced mass, the damping ratio, the end of the
// contact or the leapfrog is wrong.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double m = 0.08, k = 6e7, v = 1, R = 0.02;
const double w0 = std::sqrt(k / m), fine = 1e-4 / w0;

struct Rebound {
  double restitution;
  Impact impact;
};

// A sphere on a wall. The first step inside the wall begins `phase` steps after the touch.
Rebound on_wall(double damping_ratio, bool tension, double dt, double phase = 0.5)
{
  const ClumpShape sphere = ball(R);
  Engine engine({sphere}, {}, 0);
  engine.add_wall(plane(smooth_contact(k, damping_ratio, tension)));
  engine.add_clump(0, m / sphere.volume, {0, 0, R + (1 - phase) * v * dt}, Quaternion::Identity(),
                   {0, 0, -v});
  const Impact impact = run_impact(engine, dt);
  return {engine.clumps().velocity[0].z() / v, impact};
}

// Two spheres, radii and masses 1:2 and 1:8, with the same reduced mass, along a slanted line.
Rebound on_each_other(double damping_ratio, bool tension, double dt)
{
  const ClumpShape small = ball(R), large = ball(2 * R);
  const double density = m * (1 + 1. / 8) / small.volume;
  const Vector3 line = Vector3(1, 2, -2) / 3, middle(0.3, -0.2, 0.1), drifting(0.4, 0, -0.3);
  Engine engine({small, large}, smooth_contact(k, damping_ratio, tension), 0);
  const double apart = 3 * R + 0.5 * v * dt;
  engine.add_clump(0, density, middle, Quaternion::Identity(), drifting + v * line);
  engine.add_clump(1, density, middle + apart * line, Quaternion::Identity(), drifting);
  const Impact impact = run_impact(engine, dt);
  const Vector3 parting = engine.clumps().velocity[1] - engine.clumps().velocity[0];
  EXPECT_LT((parting - parting.dot(line) * line).norm(), 1e-8); // rounding
  return {parting.dot(line) / v, impact};
}

// Damping ratio; restitution with and without tension; w0 times the duration with and without.
constexpr double table[][5] = {
    {0.05, 0.854468, 0.858758, 3.14553, 3.04536}, {0.1, 0.729248, 0.744079, 3.15742, 2.95608},
    {0.2, 0.526621, 0.571740, 3.20638, 2.79535},  {0.3, 0.372326, 0.450975, 3.29328, 2.65448},
    {0.5, 0.163034, 0.298436, 3.62760, 2.41840},  {0.7, 0.045988, 0.210285, 4.39911, 2.22756},
    {0.9, 0.001524, 0.155283, 7.20731, 2.06945}};
} // namespace

TEST(Restitution, ElasticImpact)
{
  for (const Rebound& r : {on_wall(0, false, fine), on_each_other(0, false, fine)}) {
    EXPECT_NEAR(r.impact.duration, 114.7e-6, 0.05e-6);  // m* = 0.08 kg, k = 6e7 N/m
    EXPECT_NEAR(r.impact.peak_overlap, 36.51e-6, 5e-9); // per 1 m/s
    EXPECT_NEAR(r.impact.peak_force, 2191, 0.5);
    EXPECT_NEAR(r.impact.duration * w0, M_PI, 1e-4 * M_PI);
    EXPECT_NEAR(r.impact.peak_force, v * std::sqrt(k * m), 1e-6 * v * std::sqrt(k * m));
    EXPECT_NEAR(r.restitution, 1, 1e-8);
  }
}

TEST(Restitution, DampedImpactInBothConventions)
{
  double worst = 0, worst_duration = 0;
  for (const auto& row : table)
    for (const bool tension : {true, false}) {
      const double e = row[tension ? 1 : 2], duration = row[tension ? 3 : 4];
      for (const Rebound& r :
           {on_wall(row[0], tension, fine), on_each_other(row[0], tension, fine)}) {
        EXPECT_NEAR(r.restitution, e, 1e-4) << "damping ratio " << row[0] << ", " << tension;
        EXPECT_NEAR(r.impact.duration * w0, duration, 2e-4 * duration) << row[0] << ", " << tension;
        worst = std::max(worst, std::abs(r.restitution - e));
        worst_duration = std::max(worst_duration, std::abs(r.impact.duration * w0 / duration - 1));
      }
    }
  record("restitution_error", worst);
  record("duration_error", worst_duration);
}

// The damping ratio that belongs to a wanted restitution, for the contact with tension.
TEST(Restitution, DampingRatioOfARestitution)
{
  const double pairs[][2] = {{0.1, 0.591155}, {0.2, 0.455950}, {0.3, 0.357857}, {0.5, 0.215454},
                             {0.7, 0.112808}, {0.8, 0.070850}, {0.9, 0.033518}, {0.95, 0.016325}};
  for (const auto& [e, ratio] : pairs) EXPECT_NEAR(on_wall(ratio, true, fine).restitution, e, 1e-4);
}

// Leapfrog keeps m v- v+ + k x^2 exactly, v- and v+ before and after the kick. So, with a = (w0
// dt)^2,
//     e^2 = (1 - a p1 (1 - p1)) / (1 - a p2 (1 - p2)),
// where p1 and p2 say when within a step the contact begins and ends: |e^2 - 1| < a/4/(1 - a/4),
// and near a/4 where n + 1/2 steps fill the contact (p2 = p1 + 1/2).
TEST(Restitution, OrderTwoWithoutDashpots)
{
  for (const int n : {10, 20, 40, 80}) {
    const double dt = 2 / w0 * std::sin(M_PI / (2 * n + 1)), quarter = std::pow(w0 * dt, 2) / 4;
    double worst = 0;
    for (double phase = 0.005; phase < 1; phase += 0.01) {
      const double e = on_wall(0, false, dt, phase).restitution;
      worst = std::max(worst, std::abs(e * e - 1));
    }
    EXPECT_LT(worst, quarter / (1 - quarter)) << n;
    EXPECT_GT(worst, quarter * 0.97) << n;
  }
}

// Root mean square over when within a step the contact begins and ends.
TEST(Restitution, OrderOneWithDashpots)
{
  for (const bool tension : {true, false}) {
    std::vector<double> error;
    for (const int n : {100, 200, 400}) {
      double squares = 0;
      for (int begin = 0; begin < 10; ++begin)
        for (int end = 0; end < 10; ++end)
          squares += std::pow(
              on_wall(0.2, tension, M_PI / w0 / (n + 0.1 * end), 0.05 + 0.1 * begin).restitution -
                  table[2][tension ? 1 : 2],
              2);
      error.push_back(std::sqrt(squares / 100));
    }
    record(tension ? "rms_error_tension" : "rms_error_no_tension", error[0]);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 1, 0.1) << tension;
    EXPECT_NEAR(std::log2(error[1] / error[2]), 1, 0.1) << tension;
  }
}
