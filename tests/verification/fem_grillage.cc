// Grillages of square bays against the exact stiffness method. Fails when rigid junctions, torsion
// or the exactness of the element at its nodes are lost.
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Bending stiffness 1 in bays of side 1; shear stiffness a million times that of bending, 12
// EI/a^2, so Euler-Bernoulli to 1e-6.
BeamSection euler_bernoulli(double torsion)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 12e6;
  section.bending_2 = section.bending_3 = 1;
  section.torsion = torsion;
  section.line_density = 1;
  return section;
}

// w EI/(P a^3) under a small load at the centre of n x n bays whose edge nodes are held at w = 0.
double centre_deflection(int n, double torsion)
{
  const BeamSection section = euler_bernoulli(torsion);
  std::vector<RibLine> lines;
  for (int i = 0; i <= n; ++i) {
    lines.push_back(straight_line({0, 1. * i, 0}, {1. * n, 1. * i, 0}, n, section));
    lines.push_back(straight_line({1. * i, 0, 0}, {1. * i, 1. * n, 0}, n, section));
  }
  const Lattice lattice(lines);
  StaticOptions options;
  options.load_steps = 1;
  StaticSolver solver(lattice, options);
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Vector3d x = lattice.reference_position(i);
    if (x.x() == 0 || x.x() == n || x.y() == 0 || x.y() == n) solver.prescribe(i, 2, 0);
  }
  solver.prescribe(0, 0, 0); // and no motion in the plane
  solver.prescribe(0, 1, 0);
  solver.prescribe(lattice.nearest_node({1. * n, 0, 0}), 1, 0);
  const int centre = lattice.nearest_node({0.5 * n, 0.5 * n, 0});
  const double force = 1e-6;
  solver.add_load(centre, {0, 0, force}, {0, 0, 0});
  solver.solve();
  return solver.displacement(centre).z() / force;
}

// One element a bay is exact. Tolerance: the shear flexibility of 1e-6, and the last digit of the
// table.
TEST(Grillage, CentreDeflection)
{
  struct Row {
    double torsion, deflection[4]; // 2 x 2, 4 x 4, 6 x 6, 8 x 8
  };
  for (const Row& row : {Row{0, {0.08333333, 0.3515625, 0.7977837, 1.4223999}},
                         {0.1, {0.07312925, 0.3126416, 0.7144834, 1.2792513}},
                         {0.5, {0.05392157, 0.2262621, 0.5175161, 0.9296968}},
                         {1, {0.04487179, 0.1771403, 0.3979557, 0.7102884}}})
    for (int size = 0; size < 4; ++size) {
      const double exact = row.deflection[size];
      EXPECT_NEAR(centre_deflection(2 * (size + 1), row.torsion), exact, 2e-6 * exact + 1e-7)
          << row.torsion << " " << size;
    }
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
