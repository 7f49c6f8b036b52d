// The implicit integrator against the theory of its rule and rigid-body dynamics (the elbow
// cantilever has its own file). Fails when the rule, the gyroscopic torque, finite rotations, the
// work of loads and supports or the start are wrong.
#include "fem/implicit/implicit_dynamics.h"
#include "fem/implicit/modes.h"
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
using namespace interlock::fem;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

BeamSection soft()
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 100;
  section.torsion = section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  section.rotary_1 = 0.02;
  section.rotary_2 = section.rotary_3 = 0.01;
  return section;
}

ImplicitOptions with_radius(double radius)
{
  ImplicitOptions options;
  options.spectral_radius = radius;
  return options;
}

void clamp(StaticState& state, int node)
{
  for (int c = 0; c < 6; ++c) state.supports.push_back({node, c, 0.});
}

// One element as a spring of stiffness EA/L with half its mass.
StaticState spring(double axial)
{
  BeamSection section = soft();
  section.axial = axial;
  StaticState state(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 1, section)}));
  clamp(state, 0);
  return state;
}

// With spectral radius 1 the rule is the trapezoidal one: an oscillator turns by exactly 2
// atan(omega h/2) a step and keeps its amplitude.
TEST(ImplicitDynamics, TrapezoidalRuleOfAnOscillator)
{
  const double amplitude = 1e-6, omega = std::sqrt(2 * 100.), h = 0.3 / omega;
  StaticState start = spring(100);
  ImplicitDynamics dynamics(start, with_radius(1));
  dynamics.set_motion(1, {amplitude * omega, 0, 0}, {0, 0, 0});
  const double phase = 2 * std::atan(0.5 * omega * h);
  for (int i = 1; i <= 200; ++i) {
    dynamics.step(h);
    EXPECT_NEAR(dynamics.position(1).x() - 1, amplitude * std::sin(i * phase), 1e-8 * amplitude);
  }
  const ImplicitEnergies energies = dynamics.energies();
  const double energy = 0.25 * std::pow(amplitude * omega, 2);
  EXPECT_NEAR(energies.ledger(), energy, 1e-9 * energy);
}

// Motion far too fast for the step is multiplied by the spectral radius: all three eigenvalues of
// the rule tend to it, so that after n steps n^2 radius^n bounds what is left.
TEST(ImplicitDynamics, SpectralRadiusOfAnUnresolvedOscillator)
{
  const double amplitude = 1e-9;
  for (const auto& [radius, steps] : {std::pair{0., 3}, {0.5, 30}, {0.8, 100}}) {
    StaticState start = spring(1e8);
    const double omega = std::sqrt(2e8), h = 1000 / omega;
    ImplicitDynamics dynamics(start, with_radius(radius));
    dynamics.set_motion(1, {amplitude * omega, 0, 0}, {0, 0, 0});
    for (int i = 0; i < steps; ++i) dynamics.step(h);
    const double bound = steps * steps * std::pow(radius, steps) + 1e-5;
    EXPECT_LT(dynamics.velocity(1).norm(), bound * amplitude * omega) << radius;
  }
}

// Attitude of a free body after `time`, by Euler's equations and a fine Runge-Kutta rule.
Quaterniond free_top(const Vector3d& inertia, Vector3d spin, double time)
{
  Quaterniond attitude = Quaterniond::Identity();
  const int steps = 20000;
  const double h = time / steps;
  const auto slope = [&](const Vector3d& w) -> Vector3d {
    return -w.cross(inertia.cwiseProduct(w)).cwiseQuotient(inertia);
  };
  const auto turning = [](const Quaterniond& q, const Vector3d& w) {
    const Quaterniond rate = q * Quaterniond(0, 0.5 * w[0], 0.5 * w[1], 0.5 * w[2]);
    return rate.coeffs();
  };
  for (int i = 0; i < steps; ++i) {
    const Vector3d k1 = slope(spin), s2 = spin + 0.5 * h * k1, k2 = slope(s2);
    const Vector3d s3 = spin + 0.5 * h * k2, k3 = slope(s3), s4 = spin + h * k3;
    const auto at = [&](double share, const Eigen::Vector4d& rate) {
      return Quaterniond(Eigen::Vector4d(attitude.coeffs() + share * h * rate));
    };
    const Eigen::Vector4d q1 = turning(attitude, spin), q2 = turning(at(0.5, q1), s2),
                          q3 = turning(at(0.5, q2), s3), q4 = turning(at(1, q3), s4);
    attitude.coeffs() += h / 6 * (q1 + 2 * q2 + 2 * q3 + q4);
    attitude.normalize();
    spin += h / 6 * (k1 + 2 * k2 + 2 * k3 + slope(s4));
  }
  return attitude;
}

// One stiff element, tumbling: three unequal moments of inertia, no torque. Second order, whatever
// the spectral radius.
TEST(ImplicitDynamics, TumblingBarConvergesWithOrderTwo)
{
  BeamSection section = soft();
  section.axial = section.shear_2 = section.shear_3 = 1e8;
  section.torsion = section.bending_2 = section.bending_3 = 1e8;
  section.rotary_1 = 0.3;
  section.rotary_2 = 0.05;
  section.rotary_3 = 0.25;
  const StaticState start(Lattice({straight_line({-0.5, 0, 0}, {0.5, 0, 0}, 1, section)}));
  const Vector3d inertia(0.3, 0.25 + 0.05, 0.25 + 0.25), spin(2, 1, 1.5);
  const double time = 3;
  const Quaterniond exact = free_top(inertia, spin, time);
  for (const double radius : {0., 0.5, 0.9}) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
      const int steps = 150 << k;
      ImplicitDynamics dynamics(start, with_radius(radius));
      for (int node = 0; node < 2; ++node)
        dynamics.set_motion(node, spin.cross(dynamics.position(node)), spin);
      for (int i = 0; i < steps; ++i) dynamics.step(time / steps);
      error[k] = dynamics.orientation(0).angularDistance(exact);
    }
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.15) << radius;
    EXPECT_LT(error[1], 1e-2) << radius;
  }
}

// An elbow without supports, thrown with a spin that bends it: linear momentum stays to the
// tolerance of Newton's method, angular momentum to the order of the rule.
TEST(ImplicitDynamics, FreeFlightKeepsMomentum)
{
  double drift[2];
  const StaticState start(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 3, soft()),
                                   straight_line({1, 0, 0}, {1, 1, 0}, 3, soft())}));
  for (int k = 0; k < 2; ++k) {
    ImplicitDynamics dynamics(start, with_radius(0.8));
    const Vector3d spin(0.5, 1, -0.7), velocity(0.3, -0.2, 0.1);
    for (int i = 0; i < start.lattice.n_nodes(); ++i) {
      const Vector3d x = start.position[i];
      dynamics.set_motion(i, velocity + spin.cross(x) + Vector3d(0, 0, x.x() * x.y()), spin);
    }
    const Vector3d momentum = dynamics.momentum(), turning = dynamics.angular_momentum();
    const int steps = 200 << k;
    for (int i = 0; i < steps; ++i) dynamics.step(2. / steps);
    EXPECT_LT((dynamics.momentum() - momentum).norm(), 1e-9 * momentum.norm());
    drift[k] = (dynamics.angular_momentum() - turning).norm() / turning.norm();
  }
  EXPECT_LT(drift[1], 1e-5);
  EXPECT_NEAR(std::log2(drift[0] / drift[1]), 2, 0.2);
}

// A load that comes on at once and stays: each mode swings to twice its static amplitude.
TEST(ImplicitDynamics, SuddenLoadTwiceTheStaticResponse)
{
  const int n = 8;
  const double force = 1e-4;
  StaticState start(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, soft())}));
  clamp(start, 0);
  const NaturalMode mode = natural_modes(start, 1)[0];
  const Vector3d along = mode.shape[n].head<3>();
  const double omega = 2 * M_PI * mode.frequency;
  const double amplitude = force * along.norm() / (omega * omega); // static, of the first mode

  const int steps = 400;
  ImplicitDynamics dynamics(start, with_radius(1));
  dynamics.set_loads([&](double, ImplicitDynamics::Loads& loads) {
    loads[n].head<3>() += force * along.normalized();
  });
  const std::vector<NodeInertia> nodes = lump_inertia(start.lattice, false);
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    dynamics.step(2 * M_PI / omega / steps);
    double share = 0;
    for (int node = 0; node <= n; ++node) {
      const Quaterniond q = dynamics.orientation(node);
      share += nodes[node].mass *
               mode.shape[node].head<3>().dot(dynamics.position(node) - start.position[node]);
      share += mode.shape[node].tail<3>().dot(nodes[node].tensor * 2 * q.vec());
    }
    largest = std::max(largest, share);
  }
  EXPECT_NEAR(largest, 2 * amplitude, 1e-4 * amplitude);
}

// A support that starts to move with acceleration a carries the whole lattice: reaction M a, once
// the vibration is damped away. The work of the support is what the lattice gains.
TEST(ImplicitDynamics, MovingSupport)
{
  const double acceleration = 1e-3;
  StaticState start(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 2, soft())}));
  clamp(start, 0);
  for (const double radius : {0., 1.}) {
    ImplicitDynamics dynamics(start, with_radius(radius));
    dynamics.prescribe(0, 1, [&](double t) { return 0.5 * acceleration * t * t; });
    for (int i = 0; i < 40; ++i) dynamics.step(0.5);
    if (radius == 0)
      EXPECT_NEAR(dynamics.reaction(0)[1], acceleration, 1e-3 * acceleration);
    else
      EXPECT_NEAR(dynamics.energies().ledger(), 0, 1e-7 * dynamics.energies().support_work);
    EXPECT_NEAR(dynamics.velocity(0).y(), 20 * acceleration, 1e-9 * acceleration);
  }
}

// Starts in a bent equilibrium: rests there under its load, swings without gain when it is let go.
TEST(ImplicitDynamics, StartsFromAStaticSolution)
{
  const int n = 6;
  StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, soft())}), {});
  solver.clamp({0});
  solver.add_load(n, {0, 0, 1}, {0, 0, 0});
  solver.solve();
  ImplicitDynamics resting(solver.state(), with_radius(1)), freed(solver.state(), with_radius(1));
  freed.set_loads([](double, ImplicitDynamics::Loads&) {});
  const double energy = solver.strain_energy();
  double drift = 0;
  for (int i = 0; i < 50; ++i) {
    resting.step(0.01);
    freed.step(0.01);
    drift = std::max(drift, std::abs(freed.energies().ledger() / energy - 1));
  }
  EXPECT_LT((resting.position(n) - solver.position(n)).norm(), 1e-8);
  EXPECT_GT(freed.energies().kinetic, 0.05 * energy);
  EXPECT_LT(drift, 1e-3);
}

TEST(ImplicitDynamics, RefusesWrongInput)
{
  const StaticState start = spring(100);
  EXPECT_THROW(ImplicitDynamics(start, with_radius(1.1)), std::invalid_argument);
  ImplicitDynamics dynamics(start, with_radius(1));
  dynamics.step(0.01);
  EXPECT_THROW(dynamics.prescribe(1, 0, [](double) { return 0.; }), std::runtime_error);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
