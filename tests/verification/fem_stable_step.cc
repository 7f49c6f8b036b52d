// The stable step of the explicit integrator against the highest frequency of the assembled
// lattice, from its exact tangent (automatic differentiation) and lumped masses, and against time
// stepping. Fails when the formula promises too much, or gives away more than a sixth of the step.

// GCC 12 warns in its own header about undefined operands of vector intrinsics (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "fem/beam/beam_tangent.h"
#include "fem/explicit/explicit_dynamics.h"
#include "fem/lattice/beam_constants.h"
#include "fem/layouts/biaxial_layout.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{
using namespace interlock::fem;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Lattice small_lattice(int elements)
{
  BiaxialLayout layout;
  layout.apertures_along = layout.apertures_across = 2;
  layout.pitch_along = layout.pitch_across = 0.065;
  layout.elements_per_rib = elements;
  layout.section_along = layout.section_across = {5e-3, 2.5e-3, 2.4e9, 0.4, 910};
  return Lattice(rib_lines(layout));
}

// 2/omega_max of K u = omega^2 M u, of the lattice as it is or evenly stretched, of which `plastic`
// is plastic stretch.
double exact_limit(const Lattice& lattice, const DynamicsOptions& options, double stretch = 0,
                   double plastic = 0)
{
  const int n = 6 * lattice.n_nodes();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = stiffness;
  const Quaterniond identity = Quaterniond::Identity();
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const auto& node = lattice.element(e).node;
    const BeamTangent tangent =
        beam_tangent(beam_constants(lattice, e, options.rbf, plastic),
                     {(1 + stretch) * lattice.reference_position(node[0]),
                      (1 + stretch) * lattice.reference_position(node[1])},
                     {identity, identity}, {Vector3d::Zero(), Vector3d::Zero()});
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        stiffness.block<6, 6>(6 * node[a], 6 * node[b]) +=
            tangent.stiffness.block<6, 6>(6 * a, 6 * b);
  }
  const auto nodes = lump_inertia(lattice, options.spherical_inertia);
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    mass.block<3, 3>(6 * i, 6 * i) = nodes[i].mass * Eigen::Matrix3d::Identity();
    mass.block<3, 3>(6 * i + 3, 6 * i + 3) = nodes[i].tensor;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      0.5 * (stiffness + stiffness.transpose()), mass, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
}

// The largest kinetic energy within 20000 steps over the energy that random velocities gave at the
// start, or infinity. The motion starts so small that growth by 1e6 leaves it small: large turns
// change the frequencies, and what grows at first may stay bounded there.
double growth(const Lattice& lattice, const DynamicsOptions& options, double h)
{
  ExplicitDynamics dynamics(lattice, options);
  LatticeState state = dynamics.state();
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1e-10, 1e-10);
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    state.velocity[i] = {uniform(generator), uniform(generator), uniform(generator)};
    state.spin[i] = 1e3 * Vector3d(uniform(generator), uniform(generator), uniform(generator));
    if (!options.spherical_inertia) {
      state.spin[i].setZero();
      state.angular_momentum[i].setZero();
    }
  }
  dynamics.set_state(state);
  const double start = dynamics.energies().kinetic;
  double largest = start;
  for (int i = 0; i < 20000; ++i) {
    dynamics.step(h);
    const double kinetic = dynamics.energies().kinetic;
    if (!std::isfinite(kinetic)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, kinetic);
  }
  return largest / start;
}

TEST(StableStep, FormulaIsSafeAndNotWasteful)
{
  for (const bool spherical : {false, true})
    for (const bool rbf : {false, true})
      for (const int elements : {4, 8}) {
        DynamicsOptions options;
        options.spherical_inertia = spherical;
        options.rbf = rbf;
        const Lattice lattice = small_lattice(elements);
        const double exact = exact_limit(lattice, options);
        const double formula = ExplicitDynamics(lattice, options).stable_step();
        EXPECT_LE(formula, exact * (1 + 1e-9)) << spherical << rbf << elements;
        EXPECT_GE(formula, exact / 1.2) << spherical << rbf << elements;
      }
}

TEST(StableStep, FormulaIsSafeUnderTension)
{
  for (const bool spherical : {false, true})
    for (const double stretch : {0.02, 0.08, 0.16}) {
      DynamicsOptions options;
      options.spherical_inertia = spherical;
      const Lattice lattice = small_lattice(8);
      const double exact = exact_limit(lattice, options, stretch);
      const double formula =
          beam_frequency(lattice, lump_inertia(lattice, spherical), spherical, options.rbf)
              .stable_step(stretch * lattice.section(0).axial);
      EXPECT_LE(formula, exact) << spherical << stretch;
      EXPECT_GE(formula, exact / 1.4) << spherical << stretch;
    }
}

// Ribs that have been stretched for good and answer elastically: the tension is that of the elastic
// stretch alone, but the lever arms of shear are as long as the whole stretch makes them.
TEST(StableStep, FormulaIsSafeAfterPlasticStretch)
{
  for (const bool spherical : {false, true})
    for (const double elastic : {0.01, 0.08}) {
      const double plastic = 0.1;
      DynamicsOptions options;
      options.spherical_inertia = spherical;
      const Lattice lattice = small_lattice(8);
      const double exact = exact_limit(lattice, options, elastic + plastic, plastic);
      const double formula =
          beam_frequency(lattice, lump_inertia(lattice, spherical), spherical, options.rbf)
              .stable_step(elastic * lattice.section(0).axial, plastic);
      EXPECT_LE(formula, exact) << spherical << elastic;
      EXPECT_GE(formula, exact / 1.4) << spherical << elastic;
    }
}

TEST(StableStep, BoundedBelowGrowingAbove)
{
  const Lattice lattice = small_lattice(4);
  for (const bool spherical : {false, true}) {
    DynamicsOptions options;
    options.spherical_inertia = spherical;
    const double exact = exact_limit(lattice, options);
    EXPECT_LT(growth(lattice, options, 0.995 * exact), 10);
    EXPECT_GT(growth(lattice, options, 1.005 * exact), 1e6);
  }
}

// A free rib of equal elements whose neighbours move against each other in stretch, twist or
// bending is as fast as its elements alone, and so is a single element in shear: there the printed
// step is the limit itself. Below it, at the share r, kinetic energy may swing up to 1/(1 - r^2) of
// that at the start, as the leapfrog rule has it for the fastest mode.
TEST(StableStep, PrintedStepIsTheLimitWhereTheBoundIsSharp)
{
  BeamSection base;
  base.axial = 0.5;
  base.shear_2 = base.shear_3 = 0.1;
  base.torsion = 0.01;
  base.bending_2 = base.bending_3 = 0.005;
  base.line_density = 1;
  base.rotary_1 = 0.02;
  base.rotary_2 = base.rotary_3 = 0.01;
  BeamSection stretch = base, twist = base, bend = base, shear = base;
  stretch.axial = 5;
  twist.torsion = 0.2;
  bend.bending_2 = 0.2;
  shear.shear_3 = 10;
  for (const auto& [section, elements] : {std::pair{stretch, 6}, {twist, 6}, {bend, 6}, {shear, 1}})
    for (const bool spherical : {false, true})
      for (const bool rbf : {false, true}) {
        DynamicsOptions options;
        options.spherical_inertia = spherical;
        options.rbf = rbf;
        const Lattice lattice({straight_line({0, 0, 0}, {1, 0, 0}, elements, section)});
        const double printed = ExplicitDynamics(lattice, options).stable_step();
        EXPECT_NEAR(printed, exact_limit(lattice, options), 1e-9 * printed);
        EXPECT_LT(growth(lattice, options, 0.99 * printed), 1 / (1 - 0.99 * 0.99));
        EXPECT_GT(growth(lattice, options, 1.01 * printed), 1e6);
      }
}

// 2/omega_max of a rib in the shape of `state`, whose node `clamped` (none: -1) does not move.
double exact_limit_of_rib(const Lattice& lattice, const DynamicsOptions& options,
                          const LatticeState& state, int clamped)
{
  const int n = 6 * lattice.n_nodes();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = stiffness;
  for (int e = 0; e < lattice.n_elements(); ++e)
    stiffness.block<12, 12>(6 * e, 6 * e) +=
        beam_tangent(
            beam_constants(lattice, e, options.rbf), {state.position[e], state.position[e + 1]},
            {state.orientation[e], state.orientation[e + 1]}, {Vector3d::Zero(), Vector3d::Zero()})
            .stiffness;
  const auto nodes = lump_inertia(lattice, options.spherical_inertia);
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Eigen::Matrix3d r = state.orientation[i].toRotationMatrix();
    mass.block<3, 3>(6 * i, 6 * i) = nodes[i].mass * Eigen::Matrix3d::Identity();
    mass.block<3, 3>(6 * i + 3, 6 * i + 3) = r * nodes[i].tensor * r.transpose();
  }
  if (clamped >= 0) {
    stiffness.middleRows(6 * clamped, 6).setZero();
    stiffness.middleCols(6 * clamped, 6).setZero();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      0.5 * (stiffness + stiffness.transpose()), mass, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
}

// Nodes of a rib of elements of length 1 that turn by `turn` each, with chords that lean by `lean`
// against the frame midway and are as short as the bow between the nodes wants it (no axial force).
LatticeState bent_rib(const ExplicitDynamics& dynamics, double turn, double lean)
{
  LatticeState state = dynamics.state();
  const BeamConstants<double> beam = beam_constants(dynamics.lattice(), 0, dynamics.options().rbf);
  const double bow =
      0.5 * (beam.bowing[0] * std::pow(std::sin(lean), 2) + beam.bowing[2] * turn * turn);
  const double chord = (1 - bow) / std::cos(lean);
  Vector3d place(0, 0, 0);
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    state.position[i] = place;
    state.orientation[i] = Eigen::AngleAxisd(static_cast<double>(i) * turn, Vector3d::UnitZ());
    const double angle = (static_cast<double>(i) + 0.5) * turn + lean;
    place += chord * Vector3d(std::cos(angle), std::sin(angle), 0);
  }
  return state;
}

// Ribs bent by a constant turn of each element: bowing brings the axial stiffness into bending. The
// bound of straight ribs would be up to four times too long here. An arc at rest of eight elements,
// and a single element that leans, free and held at either end.
TEST(StableStep, BoundIsSafeForBentElements)
{
  for (const bool rbf : {true, false})
    for (const bool spherical : {true, false})
      for (const double slenderness : {16., 50., 100.})
        for (const double turn : {0.05, 0.1, 0.2, 0.4, 0.8})
          for (const double lean : {0., 0.05, -0.15})
            for (const int clamped : {-1, 0, 1}) {
              const int n = lean == 0 ? 8 : 1;
              BeamSection section;
              section.axial = section.line_density = 1;
              section.shear_2 = section.shear_3 = 0.3;
              section.bending_2 = section.bending_3 = 1 / (slenderness * slenderness);
              section.torsion = 0.6 * section.bending_2;
              const Lattice lattice(
                  {straight_line({0, 0, 0}, {1. * n, 0, 0}, n, given_section(section))});
              DynamicsOptions options;
              options.rbf = rbf;
              options.spherical_inertia = spherical;
              ExplicitDynamics dynamics(lattice, options);
              if (clamped >= 0) dynamics.clamp({clamped});
              const LatticeState state = bent_rib(dynamics, turn, lean);
              dynamics.set_state(state);
              const double exact = exact_limit_of_rib(lattice, options, state, clamped);
              EXPECT_LE(dynamics.stable_step(), exact * (1 + 1e-9))
                  << rbf << spherical << slenderness << ' ' << turn << ' ' << lean << ' '
                  << clamped;
              if (lean == 0) {
                EXPECT_GE(dynamics.stable_step(), 0.5 * exact)
                    << rbf << spherical << slenderness << ' ' << turn << ' ' << clamped;
              }
            }
}
// Speed of the nodes after `time` of a rib that starts in `state` with small velocities, held at
// its first node and by a moment at its last.
double speed_after(const Lattice& lattice, const DynamicsOptions& options, LatticeState state,
                   double moment, double share, double time)
{
  ExplicitDynamics dynamics(lattice, options);
  dynamics.clamp({0});
  const int n = lattice.n_nodes() - 1;
  for (int i = 1; i <= n; ++i)
    state.velocity[i] = 1e-9 * Vector3d(std::sin(7 * i), std::cos(5 * i), std::sin(3 * i));
  dynamics.set_state(state);
  dynamics.add_nodal_load(n, {0, 0, 0}, {0, 0, moment});
  const double h = share * dynamics.stable_step();
  double largest = 0;
  for (double t = 0; t < time; t += h) {
    dynamics.step(h);
    double square = 0;
    for (int i = 1; i <= n; ++i) square += dynamics.velocity(i).squaredNorm();
    if (t > 0.9 * time) largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

// A stout rib rolled up by an end moment to a full turn is an unstable equilibrium: small motion
// grows whatever the step, as fast with steps four times shorter. Bisection for the largest step
// that stays bounded finds no limit of the step there; 2/omega_max, above the stable step, is that.
TEST(StableStep, GrowthOfARolledUpRibIsNotThatOfTheStep)
{
  const int n = 8;
  BeamSection section;
  section.axial = section.line_density = 1;
  section.shear_2 = section.shear_3 = 0.3;
  section.bending_2 = section.bending_3 = 1. / (16 * 16);
  section.torsion = 0.6 * section.bending_2;
  const Lattice lattice({straight_line({0, 0, 0}, {1. * n, 0, 0}, n, given_section(section))});
  struct Case {
    bool rbf, spherical;
    double turn; // [rad an element]
  };
  for (const auto& [rbf, spherical, turn] : {Case{true, true, 0.8},
                                             {true, false, 0.8},
                                             {false, true, 0.8},
                                             {false, false, 0.8},
                                             {false, true, 0.4}}) {
    DynamicsOptions options;
    options.rbf = rbf;
    options.spherical_inertia = spherical;
    ExplicitDynamics dynamics(lattice, options);
    dynamics.clamp({0});
    const LatticeState state = bent_rib(dynamics, turn, 0);
    dynamics.set_state(state);
    EXPECT_LE(dynamics.stable_step(), exact_limit_of_rib(lattice, options, state, 0));
    const double moment = section.bending_3 * turn, once = 800 * dynamics.stable_step();
    const double coarse = speed_after(lattice, options, state, moment, 0.9, 2 * once);
    const double fine = speed_after(lattice, options, state, moment, 0.225, 2 * once);
    const double early = speed_after(lattice, options, state, moment, 0.9, once);
    EXPECT_GT(coarse, 1.5 * early);
    EXPECT_NEAR(coarse, fine, 0.1 * fine);
  }
}
} // namespace
