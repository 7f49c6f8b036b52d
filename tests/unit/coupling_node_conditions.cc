// Supports and loads as a user writes them. Fails when a freedom, a value or a set is mixed up, a
// load is not shared, or a slip is accepted or not named.
#include "coupling/laboratory/node_conditions.h"
#include "fem/layouts/biaxial_layout.h"
#include "tests/refusal.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

using namespace interlock;
using namespace interlock::coupling;

TEST(NodeConditions, SupportsAndLoadsAreRead)
{
  const auto supports = parse_supports(" front: all; back : x=2e-3 y rz=-0.1 ;");
  ASSERT_EQ(supports.size(), 2u);
  EXPECT_EQ(supports[0].set, "front");
  EXPECT_EQ(supports[0].freedoms.size(), 6u);
  EXPECT_EQ(supports[1].set, "back");
  const std::vector<std::pair<int, double>> expected = {{0, 2e-3}, {1, 0}, {5, -0.1}};
  EXPECT_EQ(supports[1].freedoms, expected);

  const auto loads = parse_loads("middle: fz=-5 mx=0.1");
  ASSERT_EQ(loads.size(), 1u);
  EXPECT_EQ(loads[0].load[2], -5);
  EXPECT_EQ(loads[0].load[3], 0.1);
  EXPECT_TRUE(parse_loads("").empty());
}

TEST(NodeConditions, SlipsAreNamed)
{
  const auto refused = [](const std::string& text, const std::vector<std::string>& facts) {
    expect_refusal([&] { parse_supports(text); }, "Laboratory/Supports", facts);
  };
  refused("front", {"\"front\"", "colon"});
  refused("front:", {"\"front:\"", "colon"});
  refused("front: w", {"\"w\"", "x, y, z, rx, ry, rz"});
  refused("front: x=1mm", {"\"1mm\"", "not a number"});
  refused("front: x=", {"not a number"});
  expect_refusal([] { parse_loads("back: fx"); }, "Laboratory/Loads", {"\"fx\"", "no value"});
  expect_refusal([] { nodes_of("frnt", {{"front", {0}}, {"rim", {0}}}); }, "frnt", {"front, rim"});
}

// A cantilever of two ribs pulled at its end: the reaction of the held edge is the load.
TEST(NodeConditions, LoadsAreSharedAndReactionsBalance)
{
  fem::BiaxialLayout layout;
  layout.apertures_along = 2;
  layout.apertures_across = 1;
  layout.pitch_along = layout.pitch_across = 0.05;
  layout.elements_per_rib = 2;
  layout.section_along = layout.section_across = {0.005, 0.0025, 2.4e9, 0.3, 910};
  const fem::Lattice lattice(rib_lines(layout));
  const NodeSets sets = node_sets_of_piece(lattice);
  EXPECT_EQ(sets.at("front").size(), 3u);
  EXPECT_EQ(sets.at("rim").size(), 12u);
  EXPECT_EQ(sets.at("everywhere").size(), static_cast<std::size_t>(lattice.n_nodes()));

  fem::StaticOptions options;
  options.load_steps = 1;
  fem::StaticSolver solver(lattice, options);
  apply(parse_supports("front: all"), 1, sets, solver);
  for (int k = 0; k < 2; ++k) {
    apply(parse_loads("back: fx=30 fz=0.01"), 0.5, sets, solver);
    solver.solve();
  }
  fem::NodeLoad sum = fem::NodeLoad::Zero();
  for (const int node : sets.at("front")) sum += solver.reaction(node);
  EXPECT_NEAR(sum[0], -30, 1e-6);
  EXPECT_NEAR(sum[2], -0.01, 1e-8);
}

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
