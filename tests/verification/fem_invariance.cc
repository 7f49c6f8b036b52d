// What no solution may depend on: rigid motion, the path of loading, the start of the iteration.
// Fails when rotations are interpolated or updated wrongly, or the tangent is not the derivative.
#include "fem/statics/static_solver.h"

#include "../lattice_tangent.h"
#include "fem/beam/beam_tangent.h"
#include "fem/lattice/beam_constants.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// The 45-degree bend of Bathe & Bolourchi: radius 100, section 1 x 1, E = 1e7, nu = 0.
Lattice bend(int n)
{
  RibLine arc;
  arc.section.axial = 1e7;
  arc.section.shear_2 = arc.section.shear_3 = 5e6;
  arc.section.torsion = 0.141 * 5e6;
  arc.section.bending_2 = arc.section.bending_3 = 1e7 / 12;
  arc.section.line_density = 1;
  for (int i = 0; i <= n; ++i) {
    const double angle = 0.25 * M_PI * i / n;
    arc.points.emplace_back(100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0);
  }
  return Lattice({arc});
}

StaticSolver loaded_bend(int n, double force, int load_steps)
{
  StaticOptions options;
  options.load_steps = load_steps;
  StaticSolver solver(bend(n), options);
  solver.clamp({0});
  solver.add_load(n, {0, 0, force}, {0, 0, 0});
  solver.solve();
  return solver;
}

// Ten turns in small increments, and a shift, of a bend with all strains. Rounding: 400 products of
// quaternions, and positions around 100 whose differences over an element make strains of 1e-3.
TEST(Invariance, TenTurnsOfAStrainedLattice)
{
  const int n = 8;
  const StaticSolver solver = loaded_bend(n, 600, 6);
  StaticState moved = solver.state();
  const Eigen::Quaterniond increment =
      rotation_exponential(0.05 * M_PI * Vector3d(1, 2, -2).normalized());
  for (int i = 0; i < 400; ++i)
    for (int node = 0; node <= n; ++node) {
      moved.orientation[node] = (increment * moved.orientation[node]).normalized();
      moved.position[node] = increment * moved.position[node] + Vector3d(0.01, -0.02, 0.03);
    }
  double before = 0, after = 0, largest = 0;
  for (int e = 0; e < n; ++e) {
    const SectionForces a = solver.section_forces(e);
    largest = std::max(largest, std::hypot(a.torque, std::hypot(a.moment_2, a.moment_3)));
  }
  for (int e = 0; e < n; ++e) {
    const BeamConstants<double> beam = beam_constants(moved.lattice, e, true);
    const auto energy = [&](const StaticState& state) {
      const BeamEnds<double> ends = beam_ends(state.end_positions(e), state.end_orientations(e));
      return strain_energy(beam_strains(ends, beam), beam);
    };
    before += energy(solver.state());
    after += energy(moved);
    const SectionForces a = solver.section_forces(e);
    const SectionForces b = section_forces(beam, moved.end_positions(e), moved.end_orientations(e));
    EXPECT_NEAR(b.torque, a.torque, 1e-12 * largest);
    EXPECT_NEAR(b.moment_2, a.moment_2, 1e-12 * largest);
    EXPECT_NEAR(b.moment_3, a.moment_3, 1e-12 * largest);
    EXPECT_NEAR(b.axial, a.axial, 3e-13 * 1e7);
    EXPECT_NEAR(b.shear_2, a.shear_2, 3e-13 * 5e6);
    EXPECT_NEAR(b.shear_3, a.shear_3, 3e-13 * 5e6);
  }
  EXPECT_NEAR(after, before, 1e-12 * before);
}

// The same tip whatever the number of steps, and back to nothing without the load. Newton's
// tolerance is 1e-10, the size 100.
TEST(Invariance, PathOfLoadingDoesNotMatter)
{
  const int n = 8;
  StaticSolver reference = loaded_bend(n, 600, 60);
  for (const int load_steps : {1, 6}) {
    StaticSolver solver = loaded_bend(n, 600, load_steps);
    EXPECT_LT((solver.position(n) - reference.position(n)).norm(), 1e-8) << load_steps;
    EXPECT_LT(solver.orientation(n).angularDistance(reference.orientation(n)), 1e-9) << load_steps;
    solver.add_load(n, {0, 0, -600}, {0, 0, 0});
    solver.solve();
    EXPECT_LT(solver.displacement(n).norm(), 1e-8);
    EXPECT_LT(solver.strain_energy(), 1e-12);
  }
}

// Two full turns of the end, and back, leave no strain: the bend curled up in its plane, and a
// straight rod twisted.
TEST(Invariance, TwoTurnsOfTheEndAndBack)
{
  const int n = 16;
  StaticOptions options;
  options.load_steps = 40;
  const Lattice rod({straight_line({0, 0, 0}, {100, 0, 0}, n, bend(n).section(0))});
  for (const auto& [lattice, axis] : {std::pair{bend(n), 2}, {rod, 0}}) {
    StaticSolver solver(lattice, options);
    solver.clamp({0});
    for (int c = 0; c < 3; ++c) solver.prescribe(n, 3 + c, c == axis ? 4 * M_PI : 0);
    solver.solve();
    // The least energy, that of a constant moment: half the stiffness times turn squared over
    // length.
    const double stiffness = axis == 0 ? 0.141 * 5e6 : 1e7 / 12;
    const double length = axis == 0 ? 100 : 25 * M_PI;
    const double energy = 0.5 * stiffness * 16 * M_PI * M_PI / length;
    EXPECT_NEAR(solver.strain_energy(), energy, 1e-3 * energy);
    solver.prescribe(n, 3 + axis, 0);
    solver.solve();
    EXPECT_LT(solver.strain_energy(), 1e-12 * energy) << axis;
    EXPECT_LT(solver.displacement(n).norm(), 1e-8) << axis;
  }
}

// Rigid motion turns the internal forces with it. So the tangent, less the change of nodal loads
// that turn with their nodes, has six zero singular values and no more, here in a loaded
// configuration that is bent, twisted, stretched and sheared.
TEST(Invariance, SixRigidMotionsCostNothing)
{
  const int n = 8;
  const StaticSolver solver = loaded_bend(n, 600, 6);
  LatticeSystem system(solver.state(), true, MPI_COMM_SELF);
  const std::vector<unsigned int> freedoms = free_freedoms(system);
  Eigen::MatrixXd tangent = dense_tangent(system, system.present(), freedoms);
  const Lattice& lattice = solver.state().lattice;
  ASSERT_EQ(freedoms.size(), 6u * lattice.n_nodes());
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const unsigned int dof = lattice.dof(i, 0); // nothing is tied: also the row
    NodeLoad force = solver.reaction(i);
    if (i == n) force += NodeLoad::Unit(2) * 600; // all that acts on the node
    for (int c = 0; c < 3; ++c) {
      tangent.block<3, 1>(dof, dof + 3 + c) -= Vector3d::Unit(c).cross(force.head<3>());
      tangent.block<3, 1>(dof + 3, dof + 3 + c) -= Vector3d::Unit(c).cross(force.tail<3>());
    }
  }
  // Lengths in units of an element, so that translations and turns compare.
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (unsigned int c = 3; c < 6; ++c) {
      tangent.row(lattice.dof(i, c)) /= lattice.element(0).length;
      tangent.col(lattice.dof(i, c)) /= lattice.element(0).length;
    }
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(tangent).singularValues();
  EXPECT_LT(values[values.size() - 6], 1e-13 * values[0]);
  EXPECT_GT(values[values.size() - 7], 1e-7 * values[0]);
}

// Lengths of the first Newton steps after the load has grown by `more`.
std::vector<double> newton_steps(const StaticState& state, double more, int count)
{
  LatticeSystem system(state, true, MPI_COMM_SELF);
  system.set_supports(state.supports);
  const std::vector<unsigned int> freedoms = free_freedoms(system);
  std::vector<NodeLoad> loads = state.loads;
  loads.back()[2] += more;
  dealii::Vector<double> x = system.present();
  std::vector<double> steps;
  while (static_cast<int>(steps.size()) < count) {
    auto sum = system.new_vector();
    system.internal_forces(x, sum);
    system.add_loads(loads, -1, sum);
    sum.compress(dealii::VectorOperation::add);
    const dealii::Vector<double> residual = system.gathered(sum);
    Eigen::VectorXd right_side(freedoms.size());
    for (std::size_t i = 0; i < freedoms.size(); ++i) right_side[i] = residual[freedoms[i]];
    const Eigen::VectorXd step =
        dense_tangent(system, x, freedoms).partialPivLu().solve(right_side);
    for (std::size_t i = 0; i < freedoms.size(); ++i) x[freedoms[i]] -= step[i];
    steps.push_back(step.norm());
  }
  return steps;
}

// The error of a Newton iterate is the next step. It is of second order in the error before, so
// with half the load increment the steps are 2, 4, 16 times shorter.
TEST(Invariance, NewtonConvergesQuadratically)
{
  const StaticSolver solver = loaded_bend(8, 300, 3);
  const std::vector<double> steps = newton_steps(solver.state(), 0.2, 3);
  const std::vector<double> half = newton_steps(solver.state(), 0.1, 3);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(std::log2(steps[k] / half[k]), 1 << k, 0.1 * (1 << k)) << steps[k];
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
