// A cantilever pressed along its axis beyond Euler's load: which of its equilibria is found. Fails
// when an unstable one is taken without a word, or when the stable one misses the elastica.
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::fem;

constexpr double length = 0.1, bending = 6.4e-3; // [m], [N m2]
const double euler = M_PI * M_PI * bending / (4 * length * length);

StaticSolver pressed(int load_steps, double share_of_euler, double side_load)
{
  BeamSection section;
  section.axial = 1e5;
  section.shear_2 = section.shear_3 = 1e4;
  section.torsion = section.bending_2 = section.bending_3 = bending;
  section.line_density = 1;
  const Lattice lattice({straight_line({0, 0, 0}, {length, 0, 0}, 20, section)});
  StaticOptions options;
  options.load_steps = load_steps;
  options.stable_branch = true;
  options.longest_turn = 0.5;
  StaticSolver solver(lattice, options);
  solver.clamp({0});
  solver.add_load(20, {-share_of_euler * euler, 0, side_load}, {0, 0, 0});
  solver.solve();
  return solver;
}

// Elastica at 1.884 times Euler's load: the tip turns by 120 degrees and lies at 0.803 of the
// length beside the axis (Timoshenko and Gere, Theory of elastic stability, table of section 2.7).
TEST(BuckledCantilever, SideLoadLeadsToTheStableBranch)
{
  for (const int steps : {1, 20, 200}) {
    const StaticSolver solver = pressed(steps, 1.884, 1e-2);
    EXPECT_EQ(solver.unstable_directions(), 0) << steps;
    if (solver.unstable_on_the_way() > 0) continue; // said, and another branch may be reached
    EXPECT_NEAR(solver.displacement(20).z() / length, 0.803, 0.01) << steps;
  }
  EXPECT_EQ(pressed(200, 1.884, 1e-2).unstable_on_the_way(), 0);
}

// Without a side load nothing tells it where to go: the straight state is found and named unstable,
// in both planes, and in the next mode of both above nine times the load.
TEST(BuckledCantilever, StraightStateIsCalledUnstable)
{
  EXPECT_EQ(pressed(1, 0.95, 0).unstable_directions(), 0);
  EXPECT_EQ(pressed(1, 1.05, 0).unstable_directions(), 2);
  EXPECT_EQ(pressed(1, 9.5, 0).unstable_directions(), 4);
}
} // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return RUN_ALL_TESTS();
}
