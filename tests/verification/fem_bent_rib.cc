// The order of the default element in a rib that bends: four where it stays in its plane, two where
// a second load takes it out of it, because the bow between the nodes is not coupled to the twist
// that goes with it. Fails, and prints the orders, when docs/theory/geogrid.md is wrong about that.
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Displacement of the tip of a straight rib of length 1 that is clamped at the other end.
Vector3d tip(int elements, const Vector3d& force)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e9;
  section.torsion = 0.8;
  section.bending_2 = 1;
  section.bending_3 = 1.5;
  section.line_density = 1;
  StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, elements, section)}), {});
  solver.clamp({0});
  solver.add_load(elements, force, {0, 0, 0});
  solver.solve();
  return solver.displacement(elements);
}

// From three meshes, by the differences between them: no reference is needed.
double order(const char* name, const Vector3d& force)
{
  const Vector3d coarse = tip(16, force), middle = tip(32, force), fine = tip(64, force);
  const double order = std::log2((coarse - middle).norm() / (middle - fine).norm());
  std::printf("load %s: tip moves by %.6f, order %.2f\n", name, fine.norm(), order);
  return order;
}

TEST(BentRib, OrderFourInThePlaneTwoOutOfIt)
{
  EXPECT_NEAR(order("in the plane", {0, 3, 0}), 4, 0.1);
  EXPECT_NEAR(order("out of the plane", {0, 3, 2}), 2, 0.1);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
