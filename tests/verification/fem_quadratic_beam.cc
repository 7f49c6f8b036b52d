// The quadratic beam element in the static solver against beam theory. Expected order of nodal
// results: 4 in the element length, on straight and on curved ribs. Fails when the interpolation,
// its integration, the curve of the unloaded element or its place in the solver is wrong.
#include "fem/statics/static_solver.h"
#include "tests/beam_samples.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

StaticOptions quadratic(int load_steps)
{
  StaticOptions options;
  options.order = 2;
  options.load_steps = load_steps;
  return options;
}

// Mattiasson, IJNME 17 (1981) 145-153, by elliptic integrals to seven digits. Twice as many
// elements leave a sixteenth of the error.
TEST(QuadraticBeam, ElasticaConvergesWithOrderFour)
{
  struct Row {
    double load, deflection, shortening, angle;
    int elements;     // of the coarser mesh
    double tolerance; // of the finer one
  };
  for (const Row row : {Row{1, 0.3017208, 0.0564332, 0.4613519, 2, 6e-5},
                        Row{10, 0.8106090, 0.5549956, 1.4302855, 4, 3e-5}}) {
    Vector3d error[2];
    for (int k = 0; k < 2; ++k) {
      const int n = 2 * (row.elements << k); // segments
      StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender(1e8))}),
                          quadratic(10));
      solver.clamp({0});
      solver.add_load(n, {0, 0, row.load}, {0, 0, 0});
      solver.solve();
      const Vector3d u = solver.displacement(n);
      const double angle = 2 * std::atan2(-solver.orientation(n).y(), solver.orientation(n).w());
      error[k] = {u.z() / row.deflection - 1, -u.x() / row.shortening - 1, angle / row.angle - 1};
      EXPECT_NEAR(solver.reaction(0)[2], -row.load, 1e-7 * row.load);
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(std::abs(error[1][c]), row.tolerance) << "load " << row.load;
      EXPECT_NEAR(std::log2(error[0][c] / error[1][c]), 4, 0.25) << "load " << row.load;
    }
  }
}

// 45-degree bend of Bathe & Bolourchi, IJNME 14 (1979) 961-986, with curved elements. Reference:
// boundary-value solution of the Simo-Reissner equations with G J = 0.141 G and G A = 5e6.
TEST(QuadraticBeam, CurvedCantileverInSpace)
{
  BeamSection section;
  section.axial = 1e7;
  section.shear_2 = section.shear_3 = 5e6;
  section.torsion = 0.141 * 5e6;
  section.bending_2 = section.bending_3 = 1e7 / 12;
  section.line_density = 1;
  Vector3d error[3];
  const Vector3d exact[3] = {
      {58.5405, 22.1152, 40.4748}, {51.9748, 18.3720, 48.7010}, {46.8968, 15.5603, 53.6049}};
  for (int k = 0; k < 2; ++k) {
    const int n = 2 * (4 << k); // segments
    RibLine arc;
    arc.section = section;
    for (int i = 0; i <= n; ++i) {
      const double angle = 0.25 * M_PI * i / n;
      arc.points.emplace_back(100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0);
    }
    StaticSolver solver(Lattice({arc}), quadratic(3));
    solver.clamp({0});
    for (int load = 0; load < 3; ++load) {
      solver.add_load(n, {0, 0, load == 0 ? 300. : 150.}, {0, 0, 0});
      solver.solve();
      const double before = error[load].norm();
      error[load] = solver.position(n) - exact[load];
      if (k == 0) continue;
      EXPECT_LT(error[load].norm(), 1e-3) << error[load].transpose();
      EXPECT_NEAR(std::log2(before / error[load].norm()), 4, 0.3);
    }
  }
}

// A full circle by prescribed rotation of the end: turns add up, an even curvature is exact at any
// mesh but for the chords.
TEST(QuadraticBeam, RollUpByPrescribedRotation)
{
  const int n = 16;
  StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())}), quadratic(16));
  solver.clamp({0});
  solver.prescribe(n, 3, 0);
  solver.prescribe(n, 4, 0);
  solver.prescribe(n, 5, 2 * M_PI);
  solver.solve();
  EXPECT_LT((solver.position(n) - solver.position(0)).norm(), 1e-8);
  EXPECT_NEAR(solver.reaction(n)[5], 2 * M_PI, 1e-6);
  EXPECT_NEAR(solver.strain_energy(), 2 * M_PI * M_PI, 1e-6);
  EXPECT_NEAR(solver.section_forces(5).moment_3, 2 * M_PI, 1e-6);
}

// Square grid of 4 x 4 bays, one element a bay, edge junctions held at w = 0, unit load in the
// middle: deflection w EI/(P a^3) by the exact stiffness method. A cubic is met at the nodes.
TEST(QuadraticBeam, GrillageWithTorsion)
{
  BeamSection section = slender(1e5);
  section.torsion = 0.5;
  std::vector<RibLine> lines;
  for (int i = 0; i <= 4; ++i) {
    lines.push_back(straight_line({0, 1. * i, 0}, {4, 1. * i, 0}, 8, section));
    lines.push_back(straight_line({1. * i, 0, 0}, {1. * i, 4, 0}, 8, section));
  }
  const Lattice lattice(lines);
  StaticSolver solver(lattice, quadratic(1));
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Vector3d x = lattice.reference_position(i);
    const bool junction = x == x.array().round().matrix();
    const bool edge = x.x() == 0 || x.x() == 4 || x.y() == 0 || x.y() == 4;
    if (junction && edge) solver.prescribe(i, 2, 0);
  }
  solver.prescribe(0, 0, 0); // and no motion in the plane
  solver.prescribe(0, 1, 0);
  solver.prescribe(lattice.nearest_node({4, 0, 0}), 1, 0);
  const int centre = lattice.nearest_node({2, 2, 0});
  const double force = 1e-4;
  solver.add_load(centre, {0, 0, force}, {0, 0, 0});
  solver.solve();
  EXPECT_NEAR(solver.displacement(centre).z() / force, 0.2262621, 5e-5);
}

TEST(QuadraticBeam, RefusesLatticesThatItCannotPair)
{
  const auto rib = [](int segments, const BeamSection& section) {
    return Lattice({straight_line({0, 0, 0}, {1, 0, 0}, segments, section)});
  };
  BeamSection softening = slender();
  softening.softening = 8;
  StaticOptions cubic;
  cubic.order = 3;
  EXPECT_THROW(StaticSolver(rib(3, slender()), quadratic(1)), std::invalid_argument);
  EXPECT_THROW(StaticSolver(rib(2, softening), quadratic(1)), std::invalid_argument);
  EXPECT_THROW(StaticSolver(rib(2, slender()), cubic), std::invalid_argument);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
