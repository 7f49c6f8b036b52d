// Lattices from Gmsh files of both versions against what was written into them. Fails when lines,
// sections, node sets or the unit of length are lost or mixed up.
#include "fem/gmsh/gmsh_lattice.h"
#include "fem/gmsh/line_chains.h"
#include "tests/gmsh_files.h"
#include "tests/temporary_folder.h"

#include <set>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

GmshSection section(double width, double thickness)
{
  const RibSection shape{width, thickness, 2.4e9, 0.4, 910};
  return {{shape, beam_section(shape)}, {0, 0, 1}};
}

// Three lines through one vertex, in mm; elements in no particular order and direction.
GmshText star()
{
  GmshText text;
  text.nodes = {{0, 0, 0},     {40, 0, 0},   {-40, 0, 0}, {20, 30, 0},
                {-20, -30, 0}, {-20, 30, 0}, {20, -30, 0}};
  text.line_groups = {"rib", "bar"};
  text.point_groups = {"clamp", "pull"};
  text.lines = {{0, 3, 0}, {1, 0, 1}, {6, 0, 0}, {0, 4, 0}, {2, 0, 1}, {5, 0, 0}};
  text.points = {{2, 0}, {1, 1}, {3, 1}};
  return text;
}

class Gmsh : public TemporaryFolderTest
{
};

TEST_F(Gmsh, BothVersionsGiveTheSameLattice)
{
  const std::map<std::string, GmshSection> sections = {{"rib", section(3e-3, 2e-3)},
                                                       {"bar", section(6e-3, 4e-3)}};
  for (const std::string& text : {star().version_2(), star().version_4()}) {
    const GmshLattice file =
        gmsh_lattice(read_gmsh_file(write("star.msh", text).string()), sections, 1e-3);
    ASSERT_EQ(file.lines.size(), 3u);
    const Lattice lattice(file.lines);
    EXPECT_EQ(lattice.n_nodes(), 7);
    EXPECT_EQ(lattice.n_elements(), 6);
    // The first line holds the first element and runs in its direction.
    EXPECT_LT((file.lines[0].points.front() - Vector3d(-0.02, -0.03, 0)).norm(), 1e-17);
    EXPECT_LT((file.lines[0].points.back() - Vector3d(0.02, 0.03, 0)).norm(), 1e-17);
    EXPECT_EQ(file.lines[1].shape.width, 6e-3);
    EXPECT_LT((file.lines[1].points.front() - Vector3d(0.04, 0, 0)).norm(), 1e-17);
    EXPECT_EQ(file.lines[2].shape.width, 3e-3);
    EXPECT_TRUE(file.lines[0].profiles.empty());

    const auto sets = node_sets(file, lattice);
    ASSERT_EQ(sets.size(), 2u);
    EXPECT_EQ(sets.at("clamp"), std::vector<int>{lattice.nearest_node({-0.04, 0, 0})});
    const std::set<int> pull(sets.at("pull").begin(), sets.at("pull").end());
    EXPECT_EQ(pull, (std::set<int>{lattice.nearest_node({0.04, 0, 0}),
                                   lattice.nearest_node({0.02, 0.03, 0})}));
  }
}

// Where the section changes along a rib, the line goes on with another profile.
TEST_F(Gmsh, SectionsMayChangeAlongALine)
{
  GmshText text;
  text.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0.2, 0}};
  text.line_groups = {"thin", "thick"};
  text.lines = {{0, 1, 0}, {1, 2, 1}, {2, 3, 0}};
  const GmshLattice file =
      gmsh_lattice(read_gmsh_file(write("rib.msh", text.version_2()).string()),
                   {{"thin", section(3e-3, 2e-3)}, {"thick", section(3e-3, 4e-3)}});
  ASSERT_EQ(file.lines.size(), 1u);
  const Lattice lattice(file.lines);
  EXPECT_EQ(lattice.shape(0).thickness, 2e-3);
  EXPECT_EQ(lattice.shape(1).thickness, 4e-3);
  EXPECT_EQ(lattice.shape(2).thickness, 2e-3);
  EXPECT_EQ(lattice.section(1).axial, 2 * lattice.section(0).axial);
}

// Junctions with rotational stiffness: a point of a group stands for every line's node there.
TEST_F(Gmsh, NodeSetsHoldAllNodesOfAJunction)
{
  GmshText text = star();
  text.points = {{0, 0}};
  text.point_groups = {"clamp"};
  const GmshLattice file =
      gmsh_lattice(read_gmsh_file(write("star.msh", text.version_4()).string()),
                   {{"rib", section(3e-3, 2e-3)}, {"bar", section(6e-3, 4e-3)}}, 1e-3);
  EXPECT_EQ(node_sets(file, Lattice(file.lines, {1, 1})).at("clamp").size(), 3u);
  EXPECT_EQ(node_sets(file, Lattice(file.lines)).at("clamp").size(), 1u);
}

TEST(LineChains, FollowTheStraightestAndStopAtCorners)
{
  // A rectangle's corner, then a ring of eight pieces, then a T.
  const std::vector<Vector3d> corner = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(straightest_chains(corner, {{{0, 1}}, {{1, 2}}}).size(), 2u);

  std::vector<Vector3d> ring;
  std::vector<ChainLink> links;
  for (int i = 0; i < 9; ++i) {
    ring.emplace_back(std::cos(i * M_PI / 4.5), std::sin(i * M_PI / 4.5), 0);
    links.push_back({{i, (i + 1) % 9}});
  }
  const std::vector<Chain> round = straightest_chains(ring, links);
  ASSERT_EQ(round.size(), 1u);
  EXPECT_EQ(round[0].links.front(), 0);
  EXPECT_EQ(round[0].nodes.front(), round[0].nodes.back());
  EXPECT_EQ(round[0].nodes.size(), 10u);

  const std::vector<Vector3d> tee = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Chain> chains = straightest_chains(tee, {{{3, 1}}, {{2, 1}}, {{0, 1}}});
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].nodes, (std::vector<int>{3, 1}));
  EXPECT_EQ(chains[1].nodes, (std::vector<int>{2, 1, 0}));
}
} // namespace
