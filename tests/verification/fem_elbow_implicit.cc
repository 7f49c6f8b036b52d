// The elbow cantilever by the implicit integrator, alone and against the explicit one. Fails when
// large rotations, gyroscopic torque, junction, load or the rule are wrong.
#include "fem/explicit/explicit_dynamics.h"
#include "fem/implicit/implicit_dynamics.h"
#include "tests/elbow_cantilever.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// The plain element of the reference, clamped at the origin.
ImplicitOptions with_radius(double radius)
{
  ImplicitOptions options;
  options.spectral_radius = radius;
  options.rbf = false;
  return options;
}

StaticState clamped_elbow(const Lattice& lattice)
{
  StaticState state(lattice);
  for (int c = 0; c < 6; ++c) state.supports.push_back({lattice.nearest_node({0, 0, 0}), c, 0.});
  return state;
}

struct ElbowHistory {
  std::vector<double> tip, elbow; // z after each step
  double energy_first = 0, energy_last = 0, energy_low = 1e300, energy_high = -1e300; // from t = 2
  double iterations = 0; // mean of a step
};

ElbowHistory run_elbow(int elements, double h, double radius)
{
  const Lattice lattice = elbow_lattice(elements);
  const StaticState start = clamped_elbow(lattice);
  const int elbow = lattice.nearest_node({0, 10, 0}), tip = lattice.nearest_node({10, 10, 0});
  ImplicitDynamics dynamics(start, with_radius(radius));
  dynamics.set_loads(
      [&](double t, ImplicitDynamics::Loads& loads) { loads[elbow][2] += elbow_force(t); });
  ElbowHistory history;
  const int steps = static_cast<int>(std::lround(30 / h));
  for (int i = 1; i <= steps; ++i) {
    history.iterations += static_cast<double>(dynamics.step(h)) / steps;
    history.tip.push_back(dynamics.position(tip).z());
    history.elbow.push_back(dynamics.position(elbow).z());
    if (i * h < 2 + 0.5 * h) continue;
    const ImplicitEnergies energies = dynamics.energies();
    const double energy = energies.kinetic + energies.elastic;
    if (history.energy_first == 0) history.energy_first = energy;
    history.energy_last = energy;
    history.energy_low = std::min(history.energy_low, energy);
    history.energy_high = std::max(history.energy_high, energy);
  }
  return history;
}

// Value and time of the largest of sign * z between two times, by the parabola through it and its
// neighbours.
Eigen::Vector2d extreme(const std::vector<double>& z, double h, double from, double to, double sign)
{
  std::size_t best = std::lround(from / h);
  for (std::size_t i = best; (static_cast<double>(i) + 1) * h < to; ++i)
    if (sign * z[i] > sign * z[best]) best = i;
  const double slope = 0.5 * (z[best + 1] - z[best - 1]),
               bend = z[best + 1] - 2 * z[best] + z[best - 1];
  return {z[best] - 0.5 * slope * slope / bend, h * (static_cast<double>(best) + 1 - slope / bend)};
}

// Converged extremes of an independent geometrically exact code (Exudyn, 40 elements a leg), to
// their last digit. Ours have errors of second order in step and element length; halving both and
// extrapolating leaves the next order.
TEST(ElbowImplicit, Extremes)
{
  const ElbowHistory coarse = run_elbow(10, 0.1, 0.8), fine = run_elbow(20, 0.05, 0.8);
  const auto extrapolated = [&](auto member, double from, double to, double sign) {
    const Eigen::Vector2d a = extreme(coarse.*member, 0.1, from, to, sign),
                          b = extreme(fine.*member, 0.05, from, to, sign);
    return Eigen::Vector2d((4 * b - a) / 3);
  };
  const Eigen::Vector2d tip_up = extrapolated(&ElbowHistory::tip, 5, 10, 1),
                        tip_down = extrapolated(&ElbowHistory::tip, 13, 18, -1),
                        elbow_down = extrapolated(&ElbowHistory::elbow, 8, 13, -1);
  EXPECT_NEAR(tip_up[0], 8.25, 0.01);
  EXPECT_NEAR(tip_up[1], 7.44, 0.02);
  EXPECT_NEAR(tip_down[0], -9.73, 0.01);
  EXPECT_NEAR(tip_down[1], 15.87, 0.02);
  EXPECT_NEAR(elbow_down[0], -4.06, 0.01);
  EXPECT_NEAR(elbow_down[1], 10.87, 0.03);
  EXPECT_LT(fine.iterations, 3.5);
}

// Nothing acts after t = 2. The energy swings in a band that shrinks with the square of the step,
// and does not drift beyond it, for the trapezoidal rule and for light damping.
TEST(ElbowImplicit, EnergyAfterTheLoadIsGone)
{
  for (const double radius : {0.8, 1.}) {
    double band[2];
    for (int k = 0; k < 2; ++k) {
      const ElbowHistory history = run_elbow(4, 0.1 / (1 << k), radius);
      band[k] = (history.energy_high - history.energy_low) / history.energy_first;
      EXPECT_LT(std::abs(history.energy_last / history.energy_first - 1), band[k]);
    }
    EXPECT_LT(band[1], 1e-3) << radius;
    EXPECT_NEAR(std::log2(band[0] / band[1]), 2, 0.2) << radius;
  }
}

// The same lattice by both integrators. They differ by the error of the implicit rule, of second
// order in its step.
TEST(ElbowImplicit, AgreesWithTheExplicitIntegrator)
{
  const int elements = 4;
  const double end = 4;
  const Lattice lattice = elbow_lattice(elements);
  const int clamped = lattice.nearest_node({0, 0, 0}), elbow = lattice.nearest_node({0, 10, 0});
  const int tip = lattice.nearest_node({10, 10, 0});
  DynamicsOptions explicit_options;
  explicit_options.rbf = false;
  explicit_options.spherical_inertia = false;
  ExplicitDynamics reference(lattice, explicit_options);
  reference.clamp({clamped});
  const int samples = 40, fine = 200; // steps a sample
  const double h = end / samples / fine;
  std::vector<Vector3d> place;
  for (int i = 0; i < samples * fine; ++i) {
    reference.clear_loads();
    reference.add_nodal_load(elbow, {0, 0, elbow_force(i * h)}, {0, 0, 0});
    reference.step(h);
    if ((i + 1) % fine == 0) place.push_back(reference.position(tip));
  }

  double difference[2] = {0, 0};
  const StaticState start = clamped_elbow(lattice);
  for (int k = 0; k < 2; ++k) {
    ImplicitDynamics dynamics(start, with_radius(0.9));
    dynamics.set_loads(
        [&](double t, ImplicitDynamics::Loads& loads) { loads[elbow][2] += elbow_force(t); });
    const int steps = 4 << k;
    for (int i = 0; i < samples; ++i) {
      for (int j = 0; j < steps; ++j) dynamics.step(end / samples / steps);
      difference[k] = std::max(difference[k], (dynamics.position(tip) - place[i]).norm());
    }
  }
  EXPECT_LT(difference[1], 2e-4);
  EXPECT_NEAR(std::log2(difference[0] / difference[1]), 2, 0.1);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
