// Junctions with rotational stiffness and thick zones against closed formulae of frame analysis.
// Fails when a spring acts about the wrong axis or with the wrong stiffness, when the limits are
// not pinned and rigid, or when zones have the wrong reach or stiffness.
#include "fem/layouts/junction_zones.h"
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

// A rib between two clamped cross ribs, load P in the middle. With beta = k L/(E I) the end moments
// are P L/8 beta/(2 + beta) and
//   delta = P L^3/(48 EI) (1 - 3/4 beta/(2 + beta)) + P L/(4 k G A)
// (slope of the simple beam P L^2/(16 EI), less M L/(2 EI)): P L^3/(48 EI) when pinned, a quarter
// of it when rigid. The in-plane spring acts on the load in the plane, the other on that out of it.
TEST(Junctions, BeamWithRotationalEndSprings)
{
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  const double length = 0.065, force = 1e-4;
  struct Case {
    double in_plane, out_of_plane; // beta
  };
  for (const Case beta : {Case{0, 1}, Case{0.3, 5}, Case{4, 0.2}, Case{20, infinity},
                          Case{infinity, 2}, Case{infinity, infinity}}) {
    const std::vector<RibLine> lines = {
        straight_line({0, 0, 0}, {length, 0, 0}, 6, rib),
        straight_line({0, -0.01, 0}, {0, 0.01, 0}, 2, rib),
        straight_line({length, -0.01, 0}, {length, 0.01, 0}, 2, rib)};
    const Lattice lattice(lines, {beta.in_plane * rib.bending_3 / length,
                                  beta.out_of_plane * rib.bending_2 / length});
    StaticSolver solver(lattice, one_step());
    solver.clamp(lattice.nodes_of_line(1));
    solver.clamp(lattice.nodes_of_line(2));
    const int middle = lattice.nearest_node({length / 2, 0, 0});
    solver.add_load(middle, {0, force, force}, {0, 0, 0});
    solver.solve();
    const auto deflection = [&](double b, double bending, double shear) {
      const double share = std::isinf(b) ? 1 : b / (2 + b);
      return force * std::pow(length, 3) / (48 * bending) * (1 - 0.75 * share) +
             force * length / (4 * shear);
    };
    const double in_plane = deflection(beta.in_plane, rib.bending_3, rib.shear_2);
    const double out_of_plane = deflection(beta.out_of_plane, rib.bending_2, rib.shear_3);
    EXPECT_NEAR(solver.displacement(middle).y(), in_plane, 5e-6 * in_plane) << beta.in_plane;
    EXPECT_NEAR(solver.displacement(middle).z(), out_of_plane, 5e-6 * out_of_plane)
        << beta.out_of_plane;
    // Clapeyron: the springs' energy counts.
    EXPECT_NEAR(solver.strain_energy(), 0.5 * force * (in_plane + out_of_plane),
                1e-5 * force * (in_plane + out_of_plane));
    // Across the beam; along it the bow between fixed ends pulls with the square of the load.
    const Vector3d support = solver.reaction(lattice.nearest_node({0, 0, 0})).head<3>();
    EXPECT_NEAR(support.y(), -0.5 * force, 1e-6 * force);
    EXPECT_NEAR(support.z(), -0.5 * force, 1e-6 * force);
  }
}

// Portal frame, columns clamped below, beam joined to them by springs k, pushed sideways by P. The
// beam bends antisymmetrically, so each column of height H feels K = 1/(1/k + L/(6 EI)) at its top:
//   phi = V H^2/(2 EI)/(1 + K H/EI), delta = V H^3/(3 EI) - K phi H^2/(2 EI), V = P/2,
// from the cantilever's V H^3/(3 EI) at k = 0 to the frame with rigid corners. The load is small
// enough that pull in one column and push in the other do not change their stiffness.
TEST(Junctions, SwayOfAPortalFrame)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e7; // inextensible and without shear
  section.torsion = section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  const double height = 1, width = 1.6, force = 1e-5;
  for (const double k : {0., 0.5, 8., infinity}) {
    const std::vector<RibLine> lines = {
        straight_line({0, 0, 0}, {0, height, 0}, 4, section),
        straight_line({width, 0, 0}, {width, height, 0}, 4, section),
        straight_line({0, height, 0}, {width, height, 0}, 4, section)};
    const Lattice lattice(lines, {k, infinity});
    StaticSolver solver(lattice, one_step());
    solver.clamp({lattice.nodes_of_line(0).front(), lattice.nodes_of_line(1).front()});
    const int left = lattice.nodes_of_line(0).back(), right = lattice.nodes_of_line(2).back();
    for (const int corner : {left, right}) // of a column, and of the beam
      solver.add_load(corner, {0.5 * force, 0, 0}, {0, 0, 0});
    solver.solve();
    const double spring = k == 0 ? 0 : 1 / (1 / k + width / 6), shear = 0.5 * force;
    const double turn = shear * height * height / 2 / (1 + spring * height);
    const double sway = shear * std::pow(height, 3) / 3 - spring * turn * height * height / 2;
    for (const int corner : {left, right})
      EXPECT_NEAR(solver.displacement(corner).x(), sway, 5e-6 * sway) << k;
    EXPECT_NEAR(-2 * solver.orientation(left).z(), turn, 5e-6 * turn) << k;
  }
}

// Semi-rigid frames stay objective and solvable at large rotation: an L of two legs whose corner is
// a spring, one leg clamped, the other turned by an end moment M. Every section carries M, so the
// free end turns by M (1/k + L/(EI)) and its leg is an arc.
TEST(Junctions, LargeRotationOfASpring)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e6;
  section.torsion = section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  const double moment = 0.6, k = 0.5;
  const std::vector<RibLine> lines = {straight_line({0, -1, 0}, {0, 1, 0}, 2, section),
                                      straight_line({0, 0, 0}, {1, 0, 0}, 4, section)};
  const Lattice lattice(lines, {k, infinity});
  StaticOptions options;
  options.load_steps = 4;
  StaticSolver solver(lattice, options);
  solver.clamp(lattice.nodes_of_line(0));
  const std::vector<int> leg = lattice.nodes_of_line(1);
  solver.add_load(leg.back(), {0, 0, 0}, {0, 0, moment});
  solver.solve();
  const auto angle = [&](int node) {
    return 2 * std::atan2(solver.orientation(node).z(), solver.orientation(node).w());
  };
  EXPECT_NEAR(angle(leg.front()), moment / k, 1e-8);
  EXPECT_NEAR(angle(leg.back()), moment / k + moment, 1e-8);
  EXPECT_NEAR(solver.reaction(lattice.nodes_of_line(0)[1])[5], -moment, 1e-8);
}

// Cantilever whose root is a junction with a thick zone of reach r: stretch
// F (r/EA_z + (L - r)/EA) and deflection P ((L^3 - (L - r)^3)/(3 EI_z) + (L - r)^3/(3 EI)) plus
// shear.
TEST(Junctions, CantileverWithAThickRoot)
{
  const RibSection thin{5e-3, 2e-3, 2.4e9, 0.4, 910}, thick{5e-3, 3.5e-3, 2.4e9, 0.4, 910};
  const double length = 0.065, reach = 0.009, pull = 1e-5, force = 1e-7;
  std::vector<RibLine> lines = {straight_line({0, 0, 0}, {length, 0, 0}, 3, beam_section(thin)),
                                straight_line({0, -0.01, 0}, {0, 0.01, 0}, 2, beam_section(thin))};
  for (RibLine& line : lines) line.shape = thin;
  const Lattice lattice(thicken_junctions(lines, {reach, thick.thickness}));
  StaticSolver solver(lattice, one_step());
  solver.clamp(lattice.nodes_of_line(1));
  const int tip = lattice.nodes_of_line(0).back();
  solver.add_load(tip, {pull, 0, force}, {0, 0, 0});
  solver.solve();
  const BeamSection a = beam_section(thick), b = beam_section(thin);
  const double rest = length - reach;
  const double stretch = pull * (reach / a.axial + rest / b.axial);
  const double deflection =
      force * ((std::pow(length, 3) - std::pow(rest, 3)) / (3 * a.bending_2) +
               std::pow(rest, 3) / (3 * b.bending_2) + reach / a.shear_3 + rest / b.shear_3);
  EXPECT_NEAR(solver.displacement(tip).z(), deflection, 1e-5 * deflection);
  EXPECT_NEAR(solver.displacement(tip).x(), stretch, 1e-5 * stretch);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
