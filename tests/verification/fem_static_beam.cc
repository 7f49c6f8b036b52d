// The static solver against beam theory. Expected order of the plain element: 2 in the element
// length. Fails when stiffnesses, loads, supports, finite rotations or the joints of crossing ribs
// are wrong.
#include "fem/statics/static_solver.h"
#include "tests/beam_samples.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

StaticOptions plain(int load_steps)
{
  StaticOptions options;
  options.rbf = false;
  options.load_steps = load_steps;
  return options;
}

// P L^3/(3 EI) and P L^2/(2 EI), in both planes of a rib with unequal stiffnesses, plus the shear
// deflection P L/(k G A). With residual bending flexibility every node is exact.
TEST(StaticBeam, CantileverUnderASmallLoad)
{
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  const double length = 0.065, force = 1e-3;
  const Lattice lattice({straight_line({0, 0, 0}, {length, 0, 0}, 4, rib)});
  StaticOptions options;
  options.load_steps = 1;
  StaticSolver solver(lattice, options);
  solver.clamp({0});
  solver.add_load(4, {0, force, force}, {0, 0, 0});
  solver.solve();
  const Vector3d tip = solver.displacement(4);
  const double cube = force * std::pow(length, 3) / 3;
  const double in_plane = cube / rib.bending_3 + force * length / rib.shear_2;
  const double out_of_plane = cube / rib.bending_2 + force * length / rib.shear_3;
  EXPECT_NEAR(tip.y(), in_plane, 1e-6 * in_plane);
  EXPECT_NEAR(tip.z(), out_of_plane, 1e-6 * out_of_plane);
  const double turn = force * length * length / (2 * rib.bending_3);
  EXPECT_NEAR(2 * solver.orientation(4).z(), turn, 1e-6 * turn);
  EXPECT_LT((solver.reaction(0).head<3>() + Vector3d(0, force, force)).norm(), 1e-8 * force);
  EXPECT_NEAR(solver.reaction(0)[5], -force * length, 1e-6 * force * length);
}

// A twisted rib: angle T L/(G J).
TEST(StaticBeam, TorsionOfARib)
{
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  const Lattice lattice({straight_line({0, 0, 0}, {0.065, 0, 0}, 3, rib)});
  StaticSolver solver(lattice, {});
  solver.clamp({0});
  const double torque = 0.02, angle = torque * 0.065 / rib.torsion;
  solver.add_load(3, {0, 0, 0}, {torque, 0, 0});
  solver.solve();
  EXPECT_NEAR(2 * std::atan2(solver.orientation(3).x(), solver.orientation(3).w()), angle, 1e-9);
  EXPECT_NEAR(solver.section_forces(1).torque, torque, 1e-9 * torque);
}

// Mattiasson, IJNME 17 (1981) 145-153, by elliptic integrals to seven digits.
struct ElasticaRow {
  double load, deflection, shortening, angle;
};

TEST(StaticBeam, ElasticaConvergesWithOrderTwo)
{
  for (const ElasticaRow row : {ElasticaRow{1, 0.3017208, 0.0564332, 0.4613519},
                                ElasticaRow{10, 0.8106090, 0.5549956, 1.4302855}}) {
    Vector3d error[3];
    for (int k = 0; k < 3; ++k) {
      const int n = 8 << k;
      const Lattice lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())});
      StaticSolver solver(lattice, plain(10));
      solver.clamp({0});
      solver.add_load(n, {0, 0, row.load}, {0, 0, 0});
      solver.solve();
      const Vector3d u = solver.displacement(n);
      const double angle = 2 * std::atan2(-solver.orientation(n).y(), solver.orientation(n).w());
      error[k] = {u.z() / row.deflection - 1, -u.x() / row.shortening - 1, angle / row.angle - 1};
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(std::abs(error[2][c]), 6e-4);
      EXPECT_NEAR(std::log2(error[0][c] / error[1][c]), 2, 0.15) << "load " << row.load;
      EXPECT_NEAR(std::log2(error[1][c] / error[2][c]), 2, 0.15) << "load " << row.load;
    }
  }
}

// The whole table with the default element, which has residual bending flexibility and bowing:
// fourth order, so 16 elements are 4^4 times better than the angle per element squared,
// (th/16)^4/720.
TEST(StaticBeam, ElasticaTableOfTheBowedElement)
{
  const int n = 16;
  StaticOptions options;
  options.load_steps = 1;
  StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())}), options);
  solver.clamp({0});
  double load = 0;
  for (const ElasticaRow& row : {ElasticaRow{0.2, 0.0663645, 0.0026465, 0.0996362},
                                 {0.4, 0.1309752, 0.0103539, 0.1971546},
                                 {0.6, 0.1923503, 0.0224877, 0.2907378},
                                 {0.8, 0.2494515, 0.0381656, 0.3790630},
                                 {1, 0.3017208, 0.0564332, 0.4613519},
                                 {2, 0.4934575, 0.1606417, 0.7817498},
                                 {3, 0.6032534, 0.2544202, 0.9860169},
                                 {4, 0.6699642, 0.3289412, 1.1212393},
                                 {5, 0.7137915, 0.3876284, 1.2153681},
                                 {6, 0.7445711, 0.4345888, 1.2836973},
                                 {7, 0.7673691, 0.4729274, 1.3349599},
                                 {8, 0.7849824, 0.5048277, 1.3744315},
                                 {9, 0.7990555, 0.5318206, 1.4054653},
                                 {10, 0.8106090, 0.5549956, 1.4302855}}) {
    solver.add_load(n, {0, 0, row.load - load}, {0, 0, 0});
    load = row.load;
    solver.solve();
    const double angle = 2 * std::atan2(-solver.orientation(n).y(), solver.orientation(n).w());
    EXPECT_NEAR(solver.displacement(n).z(), row.deflection, 1e-5 * row.deflection) << load;
    EXPECT_NEAR(-solver.displacement(n).x(), row.shortening, 1e-5 * row.shortening + 1e-7) << load;
    EXPECT_NEAR(angle, row.angle, 1e-5 * row.angle) << load;
  }
}

// Simo & Vu-Quoc, CMAME 58 (1986) 79-116: end moment 2 pi lambda EI/L. The exact curve is an arc;
// the element's own angles are exact at any mesh, its chord is longer than the arc's by 1 + O(h^2).
TEST(StaticBeam, RollUpByEndMoment)
{
  for (const auto& [lambda, shortening, deflection] :
       {std::array<double, 3>{0.125, 0.0996837, 0.3729232},
        {0.25, 0.3633802, 0.6366198},
        {0.5, 1, 0.6366198},
        {1, 1, 0},
        {2, 1, 0}}) {
    const int n = 40;
    const Lattice lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())});
    StaticSolver solver(lattice, plain(10));
    solver.clamp({0});
    solver.add_load(n, {0, 0, 0}, {0, 0, 2 * M_PI * lambda});
    solver.solve();
    // Second order: (2 pi lambda/n)^2/24 of the radius.
    const double tolerance = std::pow(2 * M_PI * lambda / n, 2) / 24 * 1.1 + 1e-6;
    EXPECT_NEAR(-solver.displacement(n).x(), shortening, tolerance);
    EXPECT_NEAR(solver.displacement(n).y(), deflection, tolerance);
    for (int e = 0; e < n; ++e)
      EXPECT_NEAR(solver.section_forces(e).moment_3, 2 * M_PI * lambda, 1e-7);
  }
}

// The same circle by prescribed rotation of the end, with only as much force as the clamp of the
// other freedoms needs: none. Needs rotations beyond pi to add up.
TEST(StaticBeam, RollUpByPrescribedRotation)
{
  const int n = 16;
  const Lattice lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())});
  StaticSolver solver(lattice, plain(16));
  solver.clamp({0});
  solver.prescribe(n, 3, 0);
  solver.prescribe(n, 4, 0);
  solver.prescribe(n, 5, 2 * M_PI);
  solver.solve();
  EXPECT_LT((solver.position(n) - solver.position(0)).norm(), 1e-8);
  EXPECT_NEAR(solver.reaction(n)[5], 2 * M_PI, 1e-7);
  EXPECT_NEAR(solver.strain_energy(), 2 * M_PI * M_PI, 1e-7);
}

// 45-degree bend of Bathe & Bolourchi, IJNME 14 (1979) 961-986: bending, twist and stretch
// together. Reference: boundary-value solution of the Simo-Reissner equations with G A = 5e6 and
// both torsion constants of the literature, G J = 0.141 G and G/6. Straight elements converge to it
// with order two.
TEST(StaticBeam, CurvedCantileverInSpace)
{
  struct Row {
    double torsion, force;
    Vector3d tip;
  };
  for (const Row& row : {Row{0.141, 300, {58.54051, 22.11524, 40.47479}},
                         {0.141, 450, {51.97476, 18.37204, 48.70097}},
                         {0.141, 600, {46.89677, 15.56033, 53.60486}},
                         {1. / 6, 300, {58.77912, 22.24478, 40.19189}},
                         {1. / 6, 450, {52.23856, 18.50818, 48.50293}},
                         {1. / 6, 600, {47.15044, 15.68480, 53.47486}}}) {
    BeamSection section;
    section.axial = 1e7;
    section.shear_2 = section.shear_3 = 5e6;
    section.torsion = row.torsion * 5e6;
    section.bending_2 = section.bending_3 = 1e7 / 12;
    section.line_density = 1;
    Vector3d error[2];
    for (int k = 0; k < 2; ++k) {
      const int n = 16 << k;
      RibLine arc;
      arc.section = section;
      for (int i = 0; i <= n; ++i) {
        const double angle = 0.25 * M_PI * i / n;
        arc.points.emplace_back(100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0);
      }
      StaticSolver solver(Lattice({arc}), plain(6));
      solver.clamp({0});
      solver.add_load(n, {0, 0, row.force}, {0, 0, 0});
      solver.solve();
      error[k] = solver.position(n) - row.tip;
    }
    EXPECT_LT(error[1].norm(), 0.02) << error[1].transpose();
    EXPECT_NEAR(std::log2(error[0].norm() / error[1].norm()), 2, 0.1);
  }
}

// Two ribs that cross at their middles, pinned at their ends: delta = P / sum(48 EI/L^3), and each
// carries the share I/L^3 of the load.
TEST(StaticBeam, CrossingPinnedBeamsShareTheLoad)
{
  const BeamSection section = slender(1e4);
  const double lengths[2] = {1, 1.5}, force = 1e-4;
  std::vector<RibLine> lines;
  for (int i = 0; i < 2; ++i) {
    const Vector3d half = 0.5 * lengths[i] * Vector3d::Unit(i);
    lines.push_back(straight_line(-half, half, 8, section));
  }
  const Lattice lattice(lines);
  StaticOptions options;
  options.load_steps = 1;
  StaticSolver solver(lattice, options);
  double stiffness = 0;
  for (int i = 0; i < 2; ++i) {
    const std::vector<int> nodes = lattice.nodes_of_line(i);
    solver.pin({nodes.front(), nodes.back()});
    // Bending plus shear flexibility: L^3/(48 EI) + L/(4 k G A).
    stiffness += 1 / (std::pow(lengths[i], 3) / 48 + lengths[i] / (4 * section.shear_3));
  }
  const int centre = lattice.nearest_node({0, 0, 0});
  solver.add_load(centre, {0, 0, -force}, {0, 0, 0});
  solver.solve();
  EXPECT_NEAR(solver.displacement(centre).z(), -force / stiffness, 1e-6 * force / stiffness);
  for (int i = 0; i < 2; ++i) {
    const double own = 1 / (std::pow(lengths[i], 3) / 48 + lengths[i] / (4 * section.shear_3));
    const double share = force * own / stiffness;
    const int end = lattice.nodes_of_line(i).front();
    EXPECT_NEAR(solver.reaction(end)[2], 0.5 * share, 1e-6 * force);
  }
}

} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
