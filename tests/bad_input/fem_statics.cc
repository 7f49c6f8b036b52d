// What the static solver says when there is no equilibrium: one sentence, never a number.
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <string>

namespace
{
using namespace interlock::fem;

Lattice rod(double torsion = 1)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e4;
  section.torsion = torsion;
  section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  return Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 4, section)});
}

template <class Action> void expect_not_held(const Action& action)
{
  try {
    action();
    ADD_FAILURE() << "accepted";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("The lattice is not held"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
  }
}

TEST(BadStatics, LatticeWithoutSupports)
{
  StaticSolver solver(rod(), {});
  solver.add_load(4, {0, 0, 1}, {0, 0, 0});
  expect_not_held([&] { solver.solve(); });
  expect_not_held([&] { solver.trace_path({}); });
}

TEST(BadStatics, PinnedRodSpinsAboutItself)
{
  StaticSolver solver(rod(), {});
  solver.pin({0, 4});
  solver.add_load(2, {0, 0, 1}, {0, 0, 0});
  expect_not_held([&] { solver.solve(); });
  solver.prescribe(0, 3, 0);
  EXPECT_NO_THROW(solver.solve());
}

TEST(BadStatics, LooseSecondPiece)
{
  std::vector<RibLine> lines{rod().line(0), rod().line(0)};
  for (Eigen::Vector3d& point : lines[1].points) point.y() += 1;
  StaticSolver solver(Lattice(lines), {});
  solver.clamp({0});
  expect_not_held([&] { solver.solve(); });
}

// Without torsional stiffness the nodes of a rod spin freely.
TEST(BadStatics, Mechanism)
{
  StaticSolver solver(rod(0), {});
  solver.clamp({0});
  solver.add_load(4, {0, 0, 0.1}, {0.1, 0, 0});
  expect_not_held([&] { solver.solve(); });
}

// Beyond a limit point no rest is near; the state stays that of the last step that found one.
TEST(BadStatics, NoArcWithoutALoad)
{
  StaticSolver solver(rod(), {});
  solver.clamp({0});
  EXPECT_THROW(solver.trace_path({}), std::runtime_error);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
