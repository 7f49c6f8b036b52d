// A lattice's counts, frames and ties against counting by hand. Fails when junctions are not
// joined, when freedoms are lost or doubled, or when frames do not follow the ribs.
#include "fem/lattice/lattice.h"
#include "fem/lattice/lattice_mesh.h"
#include "fem/layouts/biaxial_layout.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

BiaxialLayout layout(int along, int across, int elements)
{
  BiaxialLayout layout;
  layout.apertures_along = along;
  layout.apertures_across = across;
  layout.pitch_along = 0.065;
  layout.pitch_across = 0.04;
  layout.elements_per_rib = elements;
  layout.section_along = {5e-3, 2.5e-3, 2.4e9, 0.4, 910};
  layout.section_across = {4e-3, 2e-3, 2.4e9, 0.4, 910};
  layout.origin = {0.1, 0.2, 0.3};
  return layout;
}

TEST(Lattice, CountsOfABiaxialLayout)
{
  const int along = 3, across = 2, n = 4;
  const Lattice lattice(rib_lines(layout(along, across, n)));
  EXPECT_EQ(lattice.n_lines(), along + across + 2);
  const int elements = n * (along * (across + 1) + across * (along + 1));
  EXPECT_EQ(lattice.n_elements(), elements);
  const int junctions = (along + 1) * (across + 1), spans = elements / n;
  EXPECT_EQ(lattice.n_nodes(), junctions + spans * (n - 1));

  // deal.II holds every line's own vertices; ties leave six freedoms a node.
  const auto& mesh = lattice.mesh();
  EXPECT_EQ(mesh.dof_handler().n_dofs(), 6u * (elements + lattice.n_lines()));
  EXPECT_EQ(mesh.dof_handler().n_dofs() - mesh.junction_ties().n_constraints(),
            6u * lattice.n_nodes());
}

TEST(Lattice, LiesWhereTheLayoutSays)
{
  const Lattice lattice(rib_lines(layout(3, 2, 4)));
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    low = low.cwiseMin(lattice.reference_position(i));
    high = high.cwiseMax(lattice.reference_position(i));
  }
  EXPECT_LT((low - Vector3d(0.1, 0.16, 0.3)).norm(), 1e-15);
  EXPECT_LT((high - Vector3d(0.1 + 0.195, 0.24, 0.3)).norm(), 1e-15);

  const std::vector<int> front = lattice.front_edge_nodes();
  EXPECT_EQ(front.size(), 9u);                            // two spans of four elements
  const std::vector<int> line = lattice.nodes_of_line(3); // first transverse rib
  EXPECT_EQ(std::set<int>(front.begin(), front.end()), std::set<int>(line.begin(), line.end()));
}

TEST(Lattice, FramesFollowTheRibs)
{
  const Lattice lattice(rib_lines(layout(2, 2, 3)));
  double mass = 0;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const LatticeElement& element = lattice.element(e);
    const Vector3d chord =
        lattice.reference_position(element.node[1]) - lattice.reference_position(element.node[0]);
    EXPECT_NEAR(chord.norm(), element.length, 1e-15);
    EXPECT_LT((element.frame * Vector3d::UnitX() - chord.normalized()).norm(), 1e-14);
    EXPECT_LT((element.frame * Vector3d::UnitZ() - Vector3d::UnitZ()).norm(), 1e-14);
    EXPECT_EQ(lattice.shape(e).width, std::abs(chord.x()) > std::abs(chord.y()) ? 5e-3 : 4e-3);
    mass += element.length * lattice.shape(e).width * lattice.shape(e).thickness * 910;
  }
  EXPECT_NEAR(lattice.mass(), mass, 1e-15);
}

// After the ties are applied to arbitrary freedoms, all vertices at one place hold the same six
// values.
TEST(Lattice, TiesMakeJunctionsContinuous)
{
  const Lattice lattice(rib_lines(layout(2, 3, 2)));
  const auto& dof_handler = lattice.mesh().dof_handler();
  dealii::Vector<double> values(dof_handler.n_dofs());
  std::mt19937 generator(3);
  for (double& value : values) value = std::uniform_real_distribution<double>(-1, 1)(generator);
  lattice.mesh().junction_ties().distribute(values);
  int e = 0;
  for (const auto& cell : dof_handler.active_cell_iterators()) {
    for (unsigned int v = 0; v < 2; ++v)
      for (unsigned int c = 0; c < 6; ++c)
        EXPECT_EQ(values[cell->vertex_dof_index(v, c)],
                  values[lattice.dof(lattice.element(e).node[v], c)]);
    ++e;
  }
}

TEST(Lattice, JoinsThreeLinesAtOnePoint)
{
  const BeamSection section = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  std::vector<RibLine> lines;
  for (int i = 0; i < 3; ++i) {
    const Vector3d arm(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), 0);
    lines.push_back(straight_line(-arm, arm, 4, section));
  }
  const Lattice lattice(lines);
  EXPECT_EQ(lattice.n_nodes(), 13);
  EXPECT_EQ(lattice.nearest_node({0, 0, 0}), lattice.element(1).node[1]);
}

TEST(Lattice, RefusesWhatIsNoLattice)
{
  const BeamSection section = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  EXPECT_THROW(Lattice(std::vector<RibLine>{}), std::invalid_argument);
  EXPECT_THROW(straight_line({0, 0, 0}, {1, 0, 0}, 0, section), std::invalid_argument);
  EXPECT_THROW(Lattice({straight_line({0, 0, 0}, {0, 0, 1}, 2, section)}), std::invalid_argument);
  BiaxialLayout empty = layout(0, 1, 1);
  EXPECT_THROW(Lattice(rib_lines(empty)), std::invalid_argument);
}
} // namespace
