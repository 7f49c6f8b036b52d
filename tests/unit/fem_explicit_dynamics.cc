// The explicit integrator against conservation laws. Fails when momentum, power or energy leaks,
// when the clamp's reaction is not what the motion needs, or when a restart changes a digit.
#include "fem/explicit/explicit_dynamics.h"
#include "fem/layouts/biaxial_layout.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

std::mt19937 generator(11);

Vector3d random_vector(double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

Lattice small_lattice()
{
  BiaxialLayout layout;
  layout.apertures_along = layout.apertures_across = 2;
  layout.pitch_along = layout.pitch_across = 0.065;
  layout.elements_per_rib = 4;
  layout.section_along = layout.section_across = {5e-3, 2.5e-3, 2.4e9, 0.4, 910};
  return Lattice(rib_lines(layout));
}

// Random velocities [m/s] and spins that bend the ribs within a few thousand steps.
void stir(ExplicitDynamics& dynamics, double speed)
{
  LatticeState state = dynamics.state();
  for (int i = 0; i < dynamics.lattice().n_nodes(); ++i) {
    state.velocity[i] = random_vector(speed);
    state.spin[i] = random_vector(50 * speed);
    if (!state.angular_momentum.empty())
      state.angular_momentum[i] = dynamics.inertia(i) * state.spin[i];
  }
  dynamics.set_state(state);
}

TEST(ExplicitDynamics, FreeFlightKeepsMomentum)
{
  for (const bool spherical : {true, false}) {
    DynamicsOptions options;
    options.spherical_inertia = spherical;
    ExplicitDynamics dynamics(small_lattice(), options);
    stir(dynamics, 2);
    const auto momenta = [&] {
      const LatticeState state = dynamics.state();
      Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
      for (int i = 0; i < dynamics.lattice().n_nodes(); ++i) {
        const Vector3d p = dynamics.mass(i) * state.velocity[i];
        sum.head<3>() += p;
        sum.tail<3>() +=
            state.position[i].cross(p) +
            (spherical ? Vector3d(dynamics.inertia(i) * state.spin[i]) : state.angular_momentum[i]);
      }
      return sum;
    };
    const auto before = momenta();
    for (int i = 0; i < 20000; ++i) dynamics.step(0.9 * dynamics.stable_step());
    const auto after = momenta();
    EXPECT_LT((after - before).head<3>().norm(), 1e-11 * before.head<3>().norm());
    EXPECT_LT((after - before).tail<3>().norm(), 1e-11 * before.tail<3>().norm());
    EXPECT_LT(std::abs(dynamics.orientation(7).norm() - 1), 1e-14);
  }
}

// The work that a step books for the loads equals force and moment times the mean velocity and spin
// of the loaded points, as their users interpolate them.
TEST(ExplicitDynamics, LoadsDoTheWorkOfTheirPoint)
{
  ExplicitDynamics dynamics(small_lattice(), {});
  const int n = dynamics.lattice().n_elements();
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    stir(dynamics, 1);
    const double h = 1e-7;
    LatticeState before = dynamics.state();
    before.previous_step = h; // a full kick
    dynamics.set_state(before);
    const double work_before = dynamics.energies().load_work;
    struct Load {
      int e;
      double xi;
      Vector3d force, moment;
    };
    std::vector<Load> loads;
    double power = 0, size = 0;
    dynamics.clear_loads();
    for (int l = 0; l < 5; ++l) {
      loads.push_back({static_cast<int>(unit(generator) * n), unit(generator), random_vector(10),
                       random_vector(0.1)});
      const Load& load = loads.back();
      dynamics.add_load(load.e, load.xi, load.force, load.moment);
      power += load.force.dot(dynamics.velocity_at(load.e, load.xi)) +
               load.moment.dot(dynamics.spin_at(load.e, load.xi));
      size += load.force.norm() + 50 * load.moment.norm();
    }
    dynamics.step(h);
    for (const Load& load : loads)
      power += load.force.dot(dynamics.velocity_at(load.e, load.xi)) +
               load.moment.dot(dynamics.spin_at(load.e, load.xi));
    const double work = dynamics.energies().load_work - work_before;
    EXPECT_NEAR(work, h * 0.5 * power, 1e-12 * h * size);
  }
}

// Same digits wherever a junction's load comes from: element ends that meet there are one node.
TEST(ExplicitDynamics, JunctionsMoveAsOne)
{
  ExplicitDynamics dynamics(small_lattice(), {});
  stir(dynamics, 1);
  for (int i = 0; i < 1000; ++i) dynamics.step(0.9 * dynamics.stable_step());
  const Lattice& lattice = dynamics.lattice();
  for (int e = 0; e < lattice.n_elements(); ++e)
    for (int end = 0; end < 2; ++end)
      EXPECT_EQ(dynamics.end_position(e, end), dynamics.position(lattice.element(e).node[end]));
}

// Fast bending under gravity, loads, damping and a moving clamp. The error of the ledger falls with
// the square of the step; 1e-4 of the largest entry is ten times what the step below leaves.
TEST(ExplicitDynamics, LedgerCloses)
{
  for (const bool spherical : {true, false}) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
      DynamicsOptions options;
      options.gravity = {0, 0, -9.81};
      options.mass_damping = 50;
      options.spherical_inertia = spherical;
      ExplicitDynamics dynamics(small_lattice(), options);
      dynamics.clamp(dynamics.lattice().front_edge_nodes());
      const double start = dynamics.energies().ledger();
      const double h = (k == 0 ? 0.8 : 0.4) * dynamics.stable_step(), end = 0.02;
      for (double t = 0; t < end; t += h) {
        dynamics.set_clamp_velocity({-0.5 * std::sin(300 * t), 0, 0.3 * t / end});
        dynamics.clear_loads();
        dynamics.add_load(10, 0.3, {0.5, 0.2, -2}, {0, 3e-3, 1e-3});
        dynamics.step(h);
      }
      const LatticeEnergies e = dynamics.energies();
      EXPECT_GT(e.elastic, 1e-3);
      EXPECT_GT(e.damping_loss, 1e-4);
      EXPECT_GT(std::abs(e.clamp_work), 1e-5);
      error[k] = std::abs(e.ledger() - start) / std::abs(e.load_work);
    }
    EXPECT_LT(error[0], 1e-4) << "spherical " << spherical;
    EXPECT_LT(error[1], 0.5 * error[0]) << "spherical " << spherical;
  }
}

// A rigid geogrid with weight, load and acceleration: reaction = m a + m g - load, all three
// components.
TEST(ExplicitDynamics, RigidReactionIsNewtonsLaw)
{
  DynamicsOptions options;
  options.gravity = {0, 0, -9.81};
  options.mass_damping = 100; // must not act on prescribed nodes
  ExplicitDynamics dynamics(small_lattice(), options);
  dynamics.clamp_all();
  const double h = 1e-6, acceleration = 3, m = dynamics.lattice().mass();
  for (int i = 1; i <= 100; ++i) {
    dynamics.set_clamp_velocity({-acceleration * h * i, 0, 0});
    dynamics.clear_loads();
    dynamics.add_load(5, 0.2, {1, 2, 3}, {0.1, 0, 0});
    dynamics.step(h);
  }
  const Vector3d expected = m * Vector3d(-acceleration, 0, 9.81) - Vector3d(1, 2, 3);
  EXPECT_LT((dynamics.clamp_reaction() - expected).norm(), 1e-9);
  EXPECT_NEAR(dynamics.velocity(3).x(), -acceleration * h * 100, 1e-15);
  EXPECT_NEAR(dynamics.energies().elastic, 0, 1e-15);
  const LatticeEnergies e = dynamics.energies();
  EXPECT_NEAR(e.ledger(), 0, 1e-12);
}

// A hanging strip at rest: the clamp carries its weight, and the axial force in each element is the
// weight below its middle.
TEST(ExplicitDynamics, HangingStripAtRest)
{
  const BeamSection section = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  const Lattice strip({straight_line({0, 0, 0}, {0, 0, -0.4}, 20, section, {1, 0, 0})});
  DynamicsOptions options;
  options.gravity = {0, 0, -9.81};
  options.mass_damping = 2 * 5000; // near critical for the first axial mode
  ExplicitDynamics dynamics(strip, options);
  dynamics.clamp({0});
  for (int i = 0; i < 5000; ++i) dynamics.step(0.9 * dynamics.stable_step());
  const double weight = strip.mass() * 9.81;
  EXPECT_NEAR(dynamics.clamp_reaction().z(), weight, 1e-6 * weight);
  for (int e = 0; e < 20; ++e)
    EXPECT_NEAR(dynamics.section_forces(e).axial, weight * (19.5 - e) / 20, 1e-6 * weight);
}

TEST(ExplicitDynamics, RestartKeepsEveryDigit)
{
  for (const bool spherical : {true, false}) {
    DynamicsOptions options;
    options.mass_damping = 100;
    options.spherical_inertia = spherical;
    ExplicitDynamics first(small_lattice(), options);
    first.clamp(first.lattice().front_edge_nodes());
    first.set_clamp_velocity({-0.01, 0, 0});
    stir(first, 1);
    const double h = 0.8 * first.stable_step();
    for (int i = 0; i < 500; ++i) first.step(h);

    ExplicitDynamics second(small_lattice(), options);
    second.clamp(second.lattice().front_edge_nodes());
    second.set_clamp_velocity({-0.01, 0, 0});
    second.set_state(first.state());
    for (int i = 0; i < 500; ++i) {
      first.step(h);
      second.step(h);
    }
    for (int i = 0; i < first.lattice().n_nodes(); ++i) {
      EXPECT_EQ(first.position(i), second.position(i));
      EXPECT_EQ(first.spin(i), second.spin(i));
      EXPECT_EQ(first.orientation(i).coeffs(), second.orientation(i).coeffs());
    }
    EXPECT_EQ(first.clamp_reaction(), second.clamp_reaction());
    EXPECT_EQ(first.energies().ledger(), second.energies().ledger());
  }
}

// Blocks are dealt to three integrators in turn, the worst case for borders; each gets the motion
// of its border from those that move it. All of them must have, on what they move, the digits of
// one that moves everything.
TEST(ExplicitDynamics, PartsHaveTheDigitsOfTheWhole)
{
  for (const bool spherical : {true, false}) {
    DynamicsOptions options;
    options.spherical_inertia = spherical;
    options.mass_damping = 20;
    options.gravity = {0, 0, -9.81};
    ExplicitDynamics whole(small_lattice(), options);
    const auto prepare = [&](ExplicitDynamics& dynamics) {
      dynamics.clamp({0, 1, 2});
      dynamics.set_clamp_velocity({-0.1, 0, 0});
      dynamics.add_load(3, 0.3, {0.1, 0.2, -0.1}, {1e-4, 0, 2e-4});
      dynamics.add_nodal_load(7, {0, 0.1, 0}, {0, 0, 1e-4}); // at all slots, as everywhere
    };
    prepare(whole);
    stir(whole, 0.5);
    std::vector<ExplicitDynamics> parts;
    constexpr int n = 3;
    for (int p = 0; p < n; ++p) {
      parts.emplace_back(small_lattice(), options);
      prepare(parts[p]);
      parts[p].set_state(whole.state());
      std::vector<int> blocks;
      for (int b = p; b < whole.n_blocks(); b += n) blocks.push_back(b);
      parts[p].move_blocks(blocks);
      EXPECT_FALSE(parts[p].border_slots().empty());
    }
    const int width = ExplicitDynamics::slots_of_block();
    const auto mover = [&](int slot) { return slot / width % n; };
    const double h = 0.5 * whole.stable_step();
    for (int step = 0; step < 200; ++step) {
      whole.step(h);
      for (ExplicitDynamics& part : parts) part.step(h);
      for (ExplicitDynamics& part : parts) {
        const std::vector<double*> to = part.motion_rows();
        for (const int s : part.border_slots()) {
          const std::vector<double*> from = parts[mover(s)].motion_rows();
          for (std::size_t r = 0; r < to.size(); ++r) to[r][s] = from[r][s];
        }
      }
    }
    const std::vector<double*> expected = whole.all_rows();
    LatticeExtremes extremes;
    for (int s = 0; s < whole.n_slots(); ++s)
      for (std::size_t r = 0; r < expected.size(); ++r)
        EXPECT_EQ(parts[mover(s)].all_rows()[r][s], expected[r][s]) << s << ' ' << r;
    for (const ExplicitDynamics& part : parts) {
      extremes.force = std::max(extremes.force, part.extremes(true).force);
      extremes.bend = std::max(extremes.bend, part.extremes(true).bend);
    }
    EXPECT_EQ(extremes.force, whole.extremes(true).force);
    EXPECT_EQ(extremes.bend, whole.extremes(true).bend);
    EXPECT_NE(whole.energies().load_work, 0);
  }
}

TEST(ExplicitDynamics, RefusesAStateOfAnotherLattice)
{
  ExplicitDynamics dynamics(small_lattice(), {});
  LatticeState state = dynamics.state();
  state.velocity.pop_back();
  EXPECT_THROW(dynamics.set_state(state), std::invalid_argument);
}
} // namespace
