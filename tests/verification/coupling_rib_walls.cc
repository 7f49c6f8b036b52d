// Ribs at the walls of the box and at the edge of its slot, through the explicit dynamics of the
// loop. References: springs and Coulomb's law in closed form; a beam that is built in at one end
// and lies on the edge (Euler and Bernoulli; Gere and Timoshenko, Mechanics of Materials, 3rd ed.,
// appendix G); the energy of an undamped system. Fails when a wall carries another force than
// presses on it, a rib slides below or above the friction limit, the edge is no support, or
// contacts make energy.
#include "coupling/loop/rib_transfer.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double width = 5e-3, thickness = 2.5e-3, stiffness = 1e7, modulus = 2.4e9;
constexpr double bending = modulus * width * thickness * thickness * thickness / 12;
constexpr double bottom = 0.05;

RibBox box(double friction, double damping)
{
  RibBox box;
  box.length = 1, box.width = 1;
  box.slot_bottom = bottom, box.slot_top = 0.08;
  box.contact.normal_stiffness = box.contact.tangential_stiffness = stiffness;
  box.contact.friction = friction;
  box.contact.damping_ratio = damping;
  return box;
}

// One straight rib without weight. `held`: nodes of the clamp.
struct Beam {
  Beam(const Vector3& from, const Vector3& to, int elements, const std::vector<int>& held,
       double mass_damping, const RibBox& box, bool rigid = false)
      : ribs(lattice(from, to, elements), options(mass_damping), held, rigid, 5e-4, box)
  {
    h = 0.3 * ribs.dynamics().stable_step();
  }
  static fem::Lattice lattice(const Vector3& from, const Vector3& to, int elements)
  {
    fem::RibSection section;
    section.width = width, section.thickness = thickness;
    section.youngs_modulus = modulus, section.poisson_ratio = 0.3, section.density = 910;
    fem::RibLine line = fem::straight_line(from, to, elements, fem::beam_section(section));
    line.shape = section;
    return fem::Lattice(std::vector<fem::RibLine>{line});
  }
  static fem::DynamicsOptions options(double mass_damping)
  {
    fem::DynamicsOptions options;
    options.mass_damping = mass_damping;
    return options;
  }
  int n_nodes() const { return ribs.lattice().n_nodes(); }
  double mass(int node) const { return ribs.dynamics().mass(node); }
  // One step, or more, with an acceleration for every node and a force at node 0.
  void step(const Vector3& acceleration, const Vector3& tip = Vector3::Zero(), int n = 1)
  {
    for (int i = 0; i < n; ++i) {
      ribs.refresh_ribs();
      ribs.update_walls(h);
      ribs.apply({});
      for (int node = 0; node < n_nodes(); ++node)
        ribs.dynamics().add_nodal_load(node, mass(node) * acceleration, Vector3::Zero());
      ribs.dynamics().add_nodal_load(0, tip, Vector3::Zero());
      ribs.apply_walls(h);
      ribs.dynamics().step(h);
    }
  }
  void throw_at(const Vector3& velocity)
  {
    fem::LatticeState state = ribs.dynamics().state();
    for (Vector3& v : state.velocity) v = velocity;
    ribs.dynamics().set_state(state);
  }
  Vector3 mean_velocity() const
  {
    Vector3 sum = Vector3::Zero();
    for (int node = 0; node < n_nodes(); ++node) sum += mass(node) * ribs.dynamics().velocity(node);
    return sum / ribs.mass();
  }
  Vector3 wall_force() const { return ribs.walls()->force(); }

  RibTransfer ribs;
  double h = 0; // [s]
};

Beam beam_on_floor(double friction, double damping, double mass_damping)
{
  const double z = 0.5 * thickness;
  return Beam({0.1, 0.1, z}, {0.1, 0.2, z}, 12, {}, mass_damping, box(friction, damping));
}
} // namespace

TEST(RibsAtWalls, FloorCarriesWhatPressesTheRib)
{
  Beam beam = beam_on_floor(0, 0.5, 300);
  const double a = 2e4; // some 2 N a node
  beam.step({0, 0, -a}, Vector3::Zero(), 20000);
  EXPECT_NEAR(beam.wall_force().z(), beam.ribs.mass() * a, 1e-6 * beam.ribs.mass() * a);
  const int middle = beam.n_nodes() / 2;
  const double sunk = beam.mass(middle) * a / stiffness;
  EXPECT_NEAR(0.5 * thickness - beam.ribs.dynamics().position(middle).z(), sunk, 1e-3 * sunk);
}

// Below the limit the tangential springs hold; above it the difference accelerates the rib.
TEST(RibsAtWalls, FloorHoldsUpToTheFrictionLimit)
{
  const double a = 2e4, mu = 0.4;
  Beam beam = beam_on_floor(mu, 0.5, 0);
  beam.step({0, 0, -a}, Vector3::Zero(), 20000);
  beam.step({-0.9 * mu * a, 0, -a}, Vector3::Zero(), 20000);
  EXPECT_NEAR(beam.wall_force().x(), 0.9 * mu * a * beam.ribs.mass(), 1e-4 * a * beam.ribs.mass());
  EXPECT_LT(beam.mean_velocity().norm(), 1e-6);
  beam.step({-1.5 * mu * a, 0, -a}, Vector3::Zero(), 1000); // starts to slide
  const double before = beam.mean_velocity().x();
  const int n = 1000;
  beam.step({-1.5 * mu * a, 0, -a}, Vector3::Zero(), n);
  const double gained = -0.5 * mu * a * n * beam.h;
  EXPECT_NEAR(beam.mean_velocity().x() - before, gained, 1e-3 * std::abs(gained));
}

// A rigid rib on the edge of the slot: its clamp feels the friction there.
TEST(RibsAtWalls, ClampFeelsFrictionAtTheSlot)
{
  const double mu = 0.3, d = 1e-5, z = bottom + 0.5 * thickness;
  Beam beam({-0.1, 0.1, z}, {0.1, 0.1, z}, 25, {0}, 0, box(mu, 0), true);
  const auto move = [&](const Vector3& way, int steps) {
    beam.ribs.dynamics().set_clamp_velocity(way / (steps * beam.h));
    beam.step(Vector3::Zero(), Vector3::Zero(), steps);
  };
  move({0, 0, -d}, 1000);
  beam.ribs.dynamics().set_clamp_velocity(Vector3::Zero());
  beam.step(Vector3::Zero(), Vector3::Zero(), 2);
  EXPECT_NEAR(beam.ribs.dynamics().clamp_reaction().z(), -stiffness * d, 1e-6);
  move({-1e-3, 0, 0}, 10000);
  EXPECT_NEAR(beam.ribs.dynamics().clamp_reaction().x(), -mu * stiffness * d, 1e-6);
  EXPECT_NEAR(beam.ribs.dynamics().clamp_reaction().z(), -stiffness * d, 1e-6);
}

// Built in at x = L in the box, on the edge at x = 0, with a force P at the tip x = -a:
// deflection P a^2 L/(4 EI) + P a^3/(3 EI), the edge carries P (1 + 3 a/(2 L)). With an even number
// of elements the edge is below a vertex; in the middle of an element its force goes to both ends
// and bends the rib between them less, an error of (element/L)^2.
TEST(RibsAtWalls, EdgeOfTheSlotIsASupport)
{
  const double a = 0.1, L = 0.1, P = 0.01, z = bottom + 0.5 * thickness;
  const double tip = P * a * a * (L / 4 + a / 3) / bending;
  for (const int elements : {24, 25}) {
    Beam beam({-a, 0.1, z}, {L, 0.1, z}, elements, {elements}, 600, box(0, 0.5));
    beam.step(Vector3::Zero(), {0, 0, -P}, 40000);
    const double error = elements % 2 == 0 ? 1e-3 : 0.0064;
    EXPECT_NEAR(z - beam.ribs.dynamics().position(0).z(), tip, error * tip) << elements;
    EXPECT_NEAR(beam.wall_force().z(), P * (1 + 1.5 * a / L), 3 * error * P) << elements;
  }
}

// Thrown down, without any losses: what the rib has got back from floor or edge is what it gave,
// and what it has lost is what they hold. Over the edge it slides by more than an element.
TEST(RibsAtWalls, SpringsMakeNoEnergy)
{
  const double z = bottom + 0.5 * thickness + 1e-4;
  for (const bool at_slot : {false, true}) {
    Beam beam = at_slot ? Beam({-0.06, 0.1, z}, {0.14, 0.1, z}, 25, {}, 0, box(0, 0))
                        : Beam({0.1, 0.1, 0.0014}, {0.1, 0.2, 0.0014}, 12, {}, 0, box(0, 0));
    beam.h *= 0.3;
    beam.throw_at({-1, 0, -0.3});
    const double fall = 0.5 * beam.ribs.mass() * 0.09; // energy of the motion towards the wall
    double largest = 0, held = 0;
    for (int n = 0; n < 20000; ++n) {
      beam.step({0, 0, -300});
      const double work = beam.ribs.dynamics().energies().load_work;
      double fallen = 0; // work of the weight
      for (int node = 0; node < beam.n_nodes(); ++node)
        fallen +=
            beam.mass(node) * 300 *
            (beam.ribs.lattice().reference_position(node) - beam.ribs.dynamics().position(node))
                .z();
      const dem::ContactEnergy energy = beam.ribs.walls()->energy();
      held = std::max(held, energy.elastic);
      if (energy.elastic == 0) largest = std::max(largest, std::abs(work - fallen));
      EXPECT_EQ(energy.friction + energy.damping, 0);
    }
    EXPECT_GT(held, 0.01 * fall) << at_slot;
    EXPECT_LT(largest, 2e-3 * fall) << at_slot;
  }
}

// The same with friction and dashpots: losses of the walls are what the rib has given them.
TEST(RibsAtWalls, LedgerClosesWithLosses)
{
  const double z = bottom + 0.5 * thickness + 1e-4;
  Beam beam({-0.06, 0.1, z}, {0.14, 0.1, z}, 25, {}, 0, box(0.4, 0.2));
  beam.throw_at({-1, 0, -0.3});
  for (int n = 0; n < 20000; ++n) beam.step(Vector3::Zero());
  const dem::ContactEnergy energy = beam.ribs.walls()->energy();
  const double work = beam.ribs.dynamics().energies().load_work;
  EXPECT_GT(energy.friction, 0);
  EXPECT_GT(energy.damping, 0);
  EXPECT_NEAR(work + energy.elastic + energy.friction + energy.damping, 0,
              0.01 * (energy.friction + energy.damping));
}
