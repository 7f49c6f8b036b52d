// Buckling out of the plane of a thin frame. Fails when the tangent lacks the stiffness from
// moments and forces under finite rotations.
#include "fem/statics/static_solver.h"

#include "../lattice_tangent.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Argyris' right-angle frame: two legs of 240 mm, depth 30 mm in the plane, thickness 0.6 mm, E =
// 71 240 N/mm2, nu = 0.31; units N and mm.
BeamSection strip()
{
  const double depth = 30, thickness = 0.6, young = 71240, shear = young / (2 * 1.31);
  BeamSection section;
  section.axial = young * depth * thickness;
  section.shear_2 = section.shear_3 = 5. / 6 * shear * depth * thickness;
  section.torsion = shear * depth * std::pow(thickness, 3) / 3;
  section.bending_2 = young * depth * std::pow(thickness, 3) / 12;
  section.bending_3 = young * thickness * std::pow(depth, 3) / 12;
  section.line_density = 1;
  return section;
}

// Lowest eigenvalue of the tangent against motion out of the plane, under the load `force` at the
// free end in the direction of the first leg.
double lowest_eigenvalue(int n, double force)
{
  const Lattice lattice({straight_line({0, 0, 0}, {240, 0, 0}, n, strip()),
                         straight_line({240, 0, 0}, {240, -240, 0}, n, strip())});
  StaticOptions options;
  options.load_steps = 2;
  StaticSolver solver(lattice, options);
  solver.clamp({0});
  const int end = lattice.nearest_node({240, -240, 0});
  solver.add_load(end, {force, 0, 0}, {0, 0, 0});
  solver.solve();

  LatticeSystem system(solver.state(), true, MPI_COMM_SELF);
  std::vector<unsigned int> freedoms;
  for (int i = 1; i < lattice.n_nodes(); ++i) // z, and turns about x and y
    for (const unsigned int c : {2, 3, 4}) freedoms.push_back(lattice.dof(i, c));
  const Eigen::MatrixXd tangent = dense_tangent(system, system.present(), freedoms);
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-9 * tangent.norm());
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(tangent, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

// The load at which the frame, in equilibrium in its plane, loses its stiffness out of it: the root
// of the lowest eigenvalue between 1 N and 1.2 N by the secant method.
double critical_load(int n)
{
  double last = 1, now = 1.2, last_value = lowest_eigenvalue(n, last);
  while (std::abs(now - last) > 1e-7) {
    const double value = lowest_eigenvalue(n, now);
    const double next = now - value * (now - last) / (value - last_value);
    last = now;
    last_value = value;
    now = next;
  }
  return now;
}

// 1.088 N: Simo & Vu-Quoc (1986), Nachbagauer & Gerstmayr (2013); half a unit of the last digit.
TEST(LateralBuckling, RightAngleFrame)
{
  EXPECT_GT(lowest_eigenvalue(20, 0.5), 0); // held until then
  const double critical[3] = {critical_load(5), critical_load(10), critical_load(20)};
  EXPECT_NEAR(critical[2], 1.088, 5e-4);
  const double order = std::log2((critical[0] - critical[1]) / (critical[1] - critical[2]));
  EXPECT_NEAR(order, 2, 0.1);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
