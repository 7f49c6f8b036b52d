// Lattices as plane sheets: stiffness of square and triangular grids against the closed formulae of
// cellular solids, and the out-of-plane bracket. Fails when ribs, joints or layouts carry force
// otherwise than the sheet they stand for.
#include "fem/layouts/triaxial_layout.h"
#include "fem/statics/static_solver.h"
#include "tests/beam_samples.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Without shear flexibility: Euler-Bernoulli.
BeamSection shear_rigid(const RibSection& rib)
{
  BeamSection section = beam_section(rib);
  section.shear_2 = section.shear_3 = 1e4 * section.axial;
  return section;
}

// Square grid of n x n junctions at pitch a; ribs reach half a pitch beyond the outer ones, where
// the infinite grid has its points of inflection. So a finite piece is exact.
class SquareGrid
{
public:
  static constexpr int n = 3;
  SquareGrid(double pitch, const BeamSection& section, const JunctionStiffness& junctions)
      : pitch_(pitch), lattice_(lines(pitch, section), junctions), solver_(lattice_, one_step())
  {
  }

  // Holds all ends of ribs at the displacement gradient h: u = h x.
  void stretch(const Eigen::Matrix3d& h)
  {
    for (int l = 0; l < lattice_.n_lines(); ++l) {
      const std::vector<int> nodes = lattice_.nodes_of_line(l);
      for (const int node : {nodes.front(), nodes.back()}) {
        const Vector3d u = h * lattice_.reference_position(node);
        for (int c = 0; c < 3; ++c) solver_.prescribe(node, c, u[c]);
      }
    }
    solver_.solve();
  }

  // Force per length on the edge of largest x (axis 0) or y (axis 1) [N/m].
  Vector3d edge_force(int axis) const
  {
    Vector3d sum = Vector3d::Zero();
    for (int l = 0; l < n; ++l)
      sum += solver_.reaction(lattice_.nodes_of_line(axis * n + l).back()).head<3>();
    return sum / (n * pitch_);
  }

private:
  static std::vector<RibLine> lines(double a, const BeamSection& section)
  {
    std::vector<RibLine> lines;
    for (int axis = 0; axis < 2; ++axis)
      for (int l = 0; l < n; ++l) {
        Vector3d start = Vector3d::Zero();
        start[1 - axis] = l * a;
        start[axis] = -0.5 * a;
        lines.push_back(straight_line(start, start + n * a * Vector3d::Unit(axis), 2 * n, section));
      }
    return lines;
  }
  double pitch_;
  Lattice lattice_;
  StaticSolver solver_;
};

const RibSection rib{5e-3, 2.5e-3, 2.4e9, 0.4, 910};

// N = (EA/a) eps along the ribs, nothing across.
TEST(PlaneGrid, TensionAlongTheRibs)
{
  const double a = 0.065, strain = 1e-6;
  const BeamSection section = shear_rigid(rib);
  SquareGrid grid(a, section, {});
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  h(0, 0) = strain;
  grid.stretch(h);
  const double force = section.axial / a * strain;
  EXPECT_NEAR(grid.edge_force(0).x(), force, 1e-6 * force);
  EXPECT_LT(grid.edge_force(1).norm(), 1e-6 * force);
}

// N_xy = (6 EI/a^3) gamma with rigid joints (Gibson & Ashby: G* = E (t/l)^3/2). With a spring k
// between the ribs of a junction the half ribs and the spring act in series: each line carries the
// joint moment M = N_xy a^2, its arms bend by M a/(12 EI), the spring by M/(2 k) of each line, and
// gamma/2 is their sum: N_xy = gamma/(a^3/(6 EI) + a^2/k).
TEST(PlaneGrid, ShearOfTheSquareGrid)
{
  const double a = 0.065, shear = 1e-6;
  const BeamSection section = shear_rigid(rib);
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  h(0, 1) = shear;
  for (const double share : {infinity, 1., 0.1}) {
    const double k = share * section.bending_3 / a;
    SquareGrid grid(a, section, {k, infinity});
    grid.stretch(h);
    const double force = shear / (std::pow(a, 3) / (6 * section.bending_3) + a * a / k);
    EXPECT_NEAR(grid.edge_force(1).x(), force, 1e-5 * force) << share;
    EXPECT_NEAR(grid.edge_force(0).y(), force, 1e-5 * force) << share;
  }
  const double rigid = 6 * section.bending_3 / std::pow(a, 3) * shear;
  EXPECT_NEAR(rigid, 0.5 * 2.4e9 * std::pow(5e-3 / a, 3) * 2.5e-3 * shear, 1e-12 * rigid);
}

// Triangular grid: ribs of direction m and normal t carry EA m.eps.m and the shear
// B t.eps.m, B = 12 EI/a^2; averaged over the cell of a junction, sqrt(3)/2 a^2 with three ribs,
//   N = 2/(sqrt(3) a) sum (EA (m.eps.m) m + B (t.eps.m) t) x m.
// For a strain along any axis N_parallel = 2/(sqrt(3) a) (9/8 EA + 3/8 B) eps and
// N_perpendicular = 2/(sqrt(3) a) 3/8 (EA - B) eps: isotropic, and E* = 2/sqrt(3) EA/a without
// bending (Gibson & Ashby).
TEST(PlaneGrid, TriangularGridIsIsotropic)
{
  TriaxialLayout layout;
  layout.side = 0.046;
  layout.length = 4.1 * layout.side;
  layout.width = 4.1 * layout.side;
  layout.elements_per_rib = 2;
  layout.section_across = layout.section_rising = layout.section_falling = rib;
  std::vector<RibLine> lines = rib_lines(layout);
  const BeamSection section = shear_rigid(rib);
  for (RibLine& line : lines) line.section = section;
  const Lattice lattice(lines);
  std::vector<int> ribs_at(lattice.n_nodes(), 0);
  for (int e = 0; e < lattice.n_elements(); ++e)
    for (const int node : lattice.element(e).node) ++ribs_at[node];

  const double a = layout.side, strain = 1e-6;
  for (const double angle : {0., 0.3, M_PI / 2}) {
    const Vector3d axis(std::cos(angle), std::sin(angle), 0), across(-axis.y(), axis.x(), 0);
    const Eigen::Matrix3d h = strain * axis * axis.transpose();
    StaticSolver solver(lattice, one_step());
    for (int i = 0; i < lattice.n_nodes(); ++i) {
      // Free: points within ribs, inner junctions, and corners of two ribs, which carry nothing.
      if (ribs_at[i] == 2 || ribs_at[i] == 6) continue;
      const Vector3d u = h * lattice.reference_position(i);
      for (int c = 0; c < 3; ++c) solver.prescribe(i, c, u[c]);
      for (int c = 3; c < 6; ++c) solver.prescribe(i, c, 0);
    }
    solver.solve();
    // Mean over the cell of an inner junction: half of each of its six ribs.
    const int centre = lattice.nearest_node({2 * a, 0, 0});
    ASSERT_EQ(ribs_at[centre], 6);
    Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
    for (int e = 0; e < lattice.n_elements(); ++e) {
      const auto& node = lattice.element(e).node;
      if (node[0] != centre && node[1] != centre) continue;
      const Eigen::Matrix3d frame = lattice.element(e).frame.toRotationMatrix();
      const SectionForces f = solver.section_forces(e);
      const Vector3d force = frame * Vector3d(f.axial, f.shear_2, f.shear_3);
      stress += 0.5 * a * force * frame.col(0).transpose() / (std::sqrt(0.75) * a * a);
    }
    const double bending = 12 * section.bending_3 / (a * a), scale = 2 / (std::sqrt(3.) * a);
    const double parallel = scale * (9. / 8 * section.axial + 3. / 8 * bending) * strain;
    const double perpendicular = scale * 3. / 8 * (section.axial - bending) * strain;
    EXPECT_NEAR(axis.dot(stress * axis), parallel, 1e-5 * parallel) << angle;
    EXPECT_NEAR(across.dot(stress * across), perpendicular, 1e-5 * parallel) << angle;
    EXPECT_NEAR(axis.dot(stress * across), 0, 1e-5 * parallel) << angle;
    EXPECT_LT((solver.displacement(centre) - h * lattice.reference_position(centre)).norm(),
              1e-5 * strain * a);
  }
}

// L-shaped bracket, load out of its plane: P (L1^3 + L2^3)/(3 EI) + P L1 L2^2/(G J).
TEST(PlaneGrid, BracketLoadedOutOfItsPlane)
{
  const BeamSection section = shear_rigid(rib);
  const double first = 0.065, second = 0.04, force = 1e-5;
  const Lattice lattice({straight_line({0, 0, 0}, {first, 0, 0}, 3, section),
                         straight_line({first, 0, 0}, {first, second, 0}, 3, section)});
  StaticSolver solver(lattice, one_step());
  solver.clamp({0});
  const int tip = lattice.nodes_of_line(1).back();
  solver.add_load(tip, {0, 0, force}, {0, 0, 0});
  solver.solve();
  const double deflection =
      force * (std::pow(first, 3) + std::pow(second, 3)) / (3 * section.bending_2) +
      force * first * second * second / section.torsion;
  EXPECT_NEAR(solver.displacement(tip).z(), deflection, 1e-6 * deflection);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
