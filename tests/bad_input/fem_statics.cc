// What the static solver says when there is no equilibrium: one sentence, never a number.
#include "fem/implicit/implicit_dynamics.h"
#include "fem/implicit/modes.h"
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

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

template <class Fault, class Action>
void expect_says(const Action& action, const std::vector<std::string>& facts)
{
  try {
    action();
    ADD_FAILURE() << "accepted, although " << facts.front();
  } catch (const Fault& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
    for (const std::string& fact : facts) EXPECT_NE(text.find(fact), std::string::npos) << text;
  }
}

TEST(BadStatics, NodesFreedomsAndValues)
{
  using Fault = std::invalid_argument;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  StaticSolver solver(rod(), {});
  expect_says<Fault>([&] { solver.prescribe(2, 7, 1); }, {"Freedom 7", "node 2", "0 to 5"});
  expect_says<Fault>([&] { solver.prescribe(2, -1, 1); }, {"Freedom -1", "node 2"});
  expect_says<Fault>([&] { solver.prescribe(2, 0, nan); }, {"Freedom 0", "nan", "finite"});
  expect_says<Fault>([&] { solver.clamp({0, 5}); }, {"node 5", "0 to 4"});
  expect_says<Fault>([&] { solver.pin({-1}); }, {"node -1", "0 to 4"});
  expect_says<Fault>([&] { solver.add_load(9, {0, 0, 1}, {0, 0, 0}); }, {"node 9", "0 to 4"});
  expect_says<Fault>([&] { solver.add_load(4, {0, inf, 1}, {0, 0, 0}); }, {"(0, inf, 1)"});
  expect_says<Fault>([&] { solver.add_load(4, {0, 0, 1}, {nan, 0, 0}); }, {"(nan, 0, 0)"});
}

TEST(BadStatics, Options)
{
  StaticOptions options;
  options.load_steps = 0;
  expect_says<std::invalid_argument>([&] { StaticSolver(rod(), options); },
                                     {"load steps", " 0 ", "at least 1"});
  options.load_steps = 1;
  options.max_iterations = 0;
  expect_says<std::invalid_argument>([&] { StaticSolver(rod(), options); }, {"iterations", " 0 "});
}

TEST(BadStatics, PathsWithoutAStartOrAnEnd)
{
  StaticSolver solver(rod(), {});
  solver.clamp({0});
  solver.add_load(4, {0, 0, 1}, {0, 0, 0});
  ArcLengthOptions path;
  path.first_load = 0;
  expect_says<std::invalid_argument>([&] { solver.trace_path(path); }, {"first load", " 0 "});
  path.first_load = 0.1;
  path.max_points = 5;
  path.is_last = [](const PathPoint&) { return false; };
  expect_says<std::runtime_error>([&] { solver.trace_path(path); }, {"5 points", "max_points"});
}

// Dynamics in time needs rotary inertia. Modes do not: there are as many as freedoms with inertia,
// and the lowest ones of a slender rib hardly change.
TEST(BadStatics, NoRotaryInertia)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e4;
  section.torsion = section.bending_2 = section.bending_3 = section.line_density = 1;
  const auto held = [](const BeamSection& of) {
    StaticState state{Lattice({straight_line({0, 0, 0}, {1, 0, 0}, 8, of)})};
    for (int c = 0; c < 6; ++c) state.supports.push_back({0, c, 0.});
    return state;
  };
  const StaticState bare = held(section);
  expect_says<std::invalid_argument>([&] { ImplicitDynamics(bare, {}); },
                                     {"Rib line 0", "rotary inertia", "implicit dynamics"});
  expect_says<std::invalid_argument>([&] { natural_modes(bare, 25); }, {"25", "1 and 24"});
  const auto modes = natural_modes(bare, 24),
             complete = natural_modes(held(given_section(section)), 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(modes[i].frequency, complete[i].frequency);
    EXPECT_NEAR(modes[i].frequency, complete[i].frequency, 1e-3 * complete[i].frequency);
  }
}

TEST(BadStatics, LoadsTooLarge)
{
  StaticSolver solver(rod(), {});
  solver.clamp({0});
  solver.add_load(4, {0, 0, 1e300}, {0, 0, 0});
  expect_says<std::runtime_error>([&] { solver.solve(); }, {"loads are too large", "1e+300"});
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
