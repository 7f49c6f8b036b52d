// Ribs that soften and yield, in the static solver and in the explicit integrator. Fails when the
// path of loading, unloading and reloading is not that of the tension law, when history is lost or
// committed too early, when both solvers part, or when the ledger of energies does not close.
#include "fem/explicit/explicit_dynamics.h"
#include "fem/ribs/tension_law.h"
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Tension of a biaxial geogrid BX1100 along the machine: 4.1 kN/m at 2 %, 8.5 kN/m at 5 %, 12.4
// kN/m at most, 25 mm between ribs. Bending and mass of a rib of 3 mm x 1.5 mm.
const double force_at_5 = 0.025 * 8.5e3, strength = 0.025 * 12.4e3;
const TensionLaw law = tension_law(4.1e3 / 0.02, 8.5e3 / 0.05, 0.025, 12.4e3);

BeamSection rib()
{
  BeamSection section = beam_section({3e-3, 1.5e-3, 1.3e9, 0.4, 910});
  section.axial = law.axial;
  section.softening = law.softening;
  section.yield_force = law.yield_force;
  return section;
}

double envelope(double e)
{
  return law.axial * e / (1 + law.softening * e);
}

// A rib along x, both ends clamped, of which the last node is drawn away.
struct PulledRib {
  const double length = 0.2;
  const int n;
  StaticSolver solver;

  PulledRib(int elements, const StaticOptions& options)
      : n(elements),
        solver(Lattice({straight_line({0, 0, 0}, {length, 0, 0}, elements, rib())}), options)
  {
    solver.clamp({0, n});
  }
  // Force at a strain [N].
  double pull(double strain)
  {
    solver.prescribe(n, 0, strain * length);
    solver.solve();
    return solver.reaction(n)[0];
  }
};

StaticOptions steps(int load_steps)
{
  StaticOptions options;
  options.load_steps = load_steps;
  return options;
}

// To 5 % and back to zero force, up again and beyond: envelope, line of slope EA, residual strain,
// the same line, and the envelope as if nothing had been.
TEST(SofteningRib, FollowsItsLawDownAndUpAgain)
{
  PulledRib rib(4, steps(2));
  const double tolerance = 1e-9 * law.axial, residual = 0.05 - force_at_5 / law.axial;
  EXPECT_NEAR(rib.pull(0.02), 0.025 * 4.1e3, tolerance);
  EXPECT_NEAR(rib.pull(0.035), envelope(0.035), tolerance);
  EXPECT_NEAR(rib.pull(0.05), force_at_5, tolerance);
  for (const double e : {0.045, 0.03, residual, 0.02, residual, 0.04})
    EXPECT_NEAR(rib.pull(e), law.axial * (e - residual), tolerance) << "at " << e;
  for (int i = 0; i < rib.n; ++i) EXPECT_NEAR(rib.solver.plastic_stretch(i), residual, 1e-12);
  for (const double e : {0.05, 0.06, 0.07}) EXPECT_NEAR(rib.pull(e), envelope(e), tolerance);
  EXPECT_NEAR(rib.solver.section_forces(1).axial, envelope(0.07), tolerance);
}

// Beyond 9 % the strength holds; the rib comes back along EA. In a chain of elements one of them
// takes all further stretch.
TEST(SofteningRib, YieldsAtItsStrength)
{
  PulledRib rib(1, steps(2));
  const double tolerance = 1e-9 * law.axial;
  EXPECT_NEAR(rib.pull(0.08), envelope(0.08), tolerance);
  EXPECT_NEAR(rib.pull(0.12), strength, tolerance);
  EXPECT_NEAR(rib.pull(0.1), strength - 0.02 * law.axial, tolerance);
  EXPECT_NEAR(rib.pull(0.15), strength, tolerance);
  EXPECT_NEAR(rib.solver.plastic_stretch(0), 0.15 - strength / law.axial, 1e-12);

  PulledRib chain(4, steps(2));
  EXPECT_NEAR(chain.pull(0.08), envelope(0.08), tolerance);
  EXPECT_NEAR(chain.pull(0.12), strength, tolerance);
  EXPECT_NEAR(chain.pull(0.115), strength - 0.005 * law.axial, tolerance);
}

// The area of the loop to 5 % and back to zero force, by the trapezoidal rule on the solver's
// forces, is the plastic work: that of the hyperbola less the triangle under the unloading line.
TEST(SofteningRib, LoopAreaIsThePlasticWork)
{
  PulledRib rib(2, steps(1));
  const double residual = 0.05 - force_at_5 / law.axial;
  double area = 0, strain = 0, force = 0;
  const int n = 40;
  for (int i = 1; i <= 2 * n; ++i) {
    const double next = i <= n ? 0.05 * i / n : residual + (0.05 - residual) * (2 * n - i) / n;
    const double pulled = rib.pull(next);
    area += 0.5 * (force + pulled) * (next - strain) * rib.length;
    strain = next;
    force = pulled;
  }
  const double s = law.softening, x = s * 0.05;
  const double work =
      law.axial / (s * s) * (x - std::log1p(x)) - 0.5 * force_at_5 * force_at_5 / law.axial;
  EXPECT_NEAR(force, 0, 1e-9 * law.axial);
  EXPECT_NEAR(area, work * rib.length, 1e-3 * work * rib.length); // the rule's own error: 4e-4
  EXPECT_NEAR(plastic_work(law, residual), work, 1e-12 * law.axial);
  EXPECT_NEAR(rib.solver.strain_energy(), 0, 1e-12);
}

// A rib clamped at both ends with a load across its middle that is put on, partly taken off, and
// put on beyond: sag by stretch, with bending. Explicit, damped and so slow that inertia does not
// show.
TEST(SofteningRib, StaticAndExplicitAgree)
{
  const double length = 0.13;
  const int n = 8, middle = n / 2;
  const Lattice lattice({straight_line({0, 0, 0}, {length, 0, 0}, n, rib())});
  StaticSolver solver(lattice, steps(10));
  solver.clamp({0, n});
  DynamicsOptions options;
  options.mass_damping = 2000;
  ExplicitDynamics dynamics(lattice, options);
  dynamics.clamp({0, n});

  double load = 0;
  for (const double target : {80., 30., 130.}) {
    solver.add_load(middle, {0, 0, target - load}, {0, 0, 0});
    solver.solve();
    const double ramp = 0.1, end = 0.15;
    for (double t = 0; t < end;) {
      const double h = 0.9 * dynamics.stable_step();
      t += h;
      const double share = 0.5 - 0.5 * std::cos(M_PI * std::min(1., t / ramp));
      dynamics.clear_loads();
      dynamics.add_nodal_load(middle, {0, 0, load + share * (target - load)}, {0, 0, 0});
      dynamics.step(h);
    }
    load = target;
    const double sag = solver.displacement(middle).z();
    EXPECT_GT(sag, 0.05 * length);
    EXPECT_NEAR(dynamics.position(middle).z(), sag, 1e-5 * sag) << "at load " << target;
    for (int e = 0; e < n; ++e) {
      const double force = solver.section_forces(e).axial;
      EXPECT_NEAR(dynamics.section_forces(e).axial, force, 1e-5 * force);
      EXPECT_NEAR(dynamics.plastic_stretch(e), solver.plastic_stretch(e), 1e-6);
    }
  }
  EXPECT_GT(solver.plastic_stretch(0), 0.01);
}

// Drawn by a spring at its end beyond yield, off and again, with damping and a push across: what
// the loads did is kinetic, stored, damped or plastic work. The error falls with the square of the
// step.
TEST(SofteningRib, LedgerClosesWhileItYields)
{
  const int n = 8;
  const Lattice lattice({straight_line({0, 0, 0}, {0.2, 0, 0}, n, rib())});
  const double where_it_yields = 1 / (law.axial / strength - law.softening);
  double error[2];
  for (int k = 0; k < 2; ++k) {
    DynamicsOptions options;
    options.mass_damping = 500;
    ExplicitDynamics dynamics(lattice, options);
    dynamics.clamp({0});
    const double h = (k == 0 ? 0.3 : 0.15) * dynamics.stable_step(), end = 0.02;
    for (double t = 0; t < end; t += h) {
      const double draw = std::sin(2 * M_PI * t / end);
      const double target = 0.2 + 0.035 * draw * draw;
      dynamics.clear_loads();
      dynamics.add_nodal_load(n, {2e4 * (target - dynamics.position(n).x()), 0, 5 * draw},
                              {0, 0, 0});
      dynamics.step(h);
    }
    double plastic = 0;
    for (int e = 0; e < n; ++e) plastic = std::max(plastic, dynamics.plastic_stretch(e));
    EXPECT_GT(plastic, 1.1 * (where_it_yields - strength / law.axial));
    const LatticeEnergies e = dynamics.energies();
    EXPECT_GT(e.plastic_loss, 0.3 * e.load_work);
    error[k] = std::abs(e.ledger()) / e.load_work;
  }
  EXPECT_LT(error[0], 1e-4);
  EXPECT_LT(error[1], 0.5 * error[0]);
}

// A restart in the middle of yielding keeps every digit.
TEST(SofteningRib, RestartKeepsThePlasticStretch)
{
  const Lattice lattice({straight_line({0, 0, 0}, {0.2, 0, 0}, 8, rib())});
  ExplicitDynamics first(lattice, {}), second(lattice, {});
  const double h = 0.5 * first.stable_step();
  const auto run = [&](ExplicitDynamics& dynamics) {
    dynamics.clamp({0});
    dynamics.clear_loads();
    dynamics.add_nodal_load(8, {250, 0, 5}, {0, 0, 0});
    for (int i = 0; i < 500; ++i) dynamics.step(h);
  };
  run(first);
  second.set_state(first.state());
  EXPECT_EQ(second.stable_step() > 0, true);
  run(first);
  run(second);
  EXPECT_GT(first.plastic_stretch(0), 0.01);
  for (int e = 0; e < 8; ++e) {
    EXPECT_EQ(first.plastic_stretch(e), second.plastic_stretch(e));
    EXPECT_EQ(first.end_position(e, 1), second.end_position(e, 1));
  }
  LatticeState state = first.state();
  state.plastic_stretch.pop_back();
  EXPECT_THROW(second.set_state(state), std::invalid_argument);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
