// Load steps that go wrong on the way: tangents that cannot be factorised, branches that do not
// belong to the load, loads below the rounding of the axial stiffness, lattices far from zero.
// Fails when the answer depends on the number of load steps, is another branch, or is zero.
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

BeamSection rod(double torsion, double bending_3)
{
  BeamSection section;
  section.axial = 1e4;
  section.shear_2 = section.shear_3 = 5e3;
  section.torsion = torsion;
  section.bending_2 = 1;
  section.bending_3 = bending_3;
  section.line_density = 1;
  return section;
}

// Force along the axis of a helix of two turns, clamped below and held in place above, whose upper
// end has been moved by `stretch`.
double helix_force(int elements, double stretch, int load_steps, bool rbf, bool pinned)
{
  RibLine line;
  line.section = rod(0.8, 1.5);
  for (int i = 0; i <= elements; ++i) {
    const double t = 4 * M_PI * i / elements;
    line.points.emplace_back(std::cos(t), std::sin(t), 0.3 * t);
  }
  StaticOptions options;
  options.load_steps = load_steps;
  options.rbf = rbf;
  StaticSolver solver(Lattice({line}), options);
  solver.clamp({0});
  pinned ? solver.pin({elements}) : solver.clamp({elements});
  solver.prescribe(elements, 2, stretch);
  solver.solve();
  EXPECT_LT(solver.imbalance(), 1e-8);
  return solver.reaction(elements)[2];
}

// The prescribed motion strains one element at the start of each step; MUMPS refuses some of the
// tangents on the way. Both elements converge to one force from either side, with order two.
TEST(LoadSteps, HelixDoesNotDependOnThem)
{
  for (const bool pinned : {true, false}) {
    double plain[2], bowed[2];
    for (int k = 0; k < 2; ++k) {
      const int n = 24 << k;
      plain[k] = helix_force(n, 2.84, 10, false, pinned);
      bowed[k] = helix_force(n, 2.84, 10, true, pinned);
      for (const int load_steps : {1, 2}) {
        EXPECT_NEAR(helix_force(n, 2.84, load_steps, false, pinned), plain[k], 1e-7 * plain[k]);
        EXPECT_NEAR(helix_force(n, 2.84, load_steps, true, pinned), bowed[k], 1e-7 * bowed[k]);
      }
    }
    const double limit = plain[1] + (plain[1] - plain[0]) / 3;
    EXPECT_NEAR(bowed[1] + (bowed[1] - bowed[0]) / 3, limit, 1e-3 * limit);
  }
}

// Two half circles that make an S, drawn out to 0.8625 of what there is to draw. Shooting on the
// rod's differential equation gives F = 2.01; the wrong branch folds up in the first element.
TEST(LoadSteps, DrawnSDoesNotFoldUp)
{
  const int n = 64;
  RibLine line;
  line.section = rod(1, 1);
  for (int i = 0; i <= n; ++i) {
    const double t = 2 * M_PI * i / n;
    line.points.emplace_back(t <= M_PI + 1e-12 ? Vector3d(1 - std::cos(t), std::sin(t), 0)
                                               : Vector3d(3 + std::cos(t), std::sin(t), 0));
  }
  for (const int order : {1, 2}) {
    StaticOptions options;
    options.order = order;
    StaticSolver solver(Lattice({line}), options);
    for (const int node : {0, n})
      for (int c = 0; c < 5; ++c) solver.prescribe(node, c, 0);
    for (const double drawn : {1.0265482457436, 1.9690260418206}) {
      solver.prescribe(n, 0, drawn);
      solver.solve();
    }
    EXPECT_NEAR(solver.reaction(n)[0], 2.01, order == 2 ? 0.005 : 0.03);
    EXPECT_EQ(solver.stability(), Stability::stable);
  }
}

// A rib 3 mm wide and 0.76 mm thick, 0.28 m long: under 1 mN its tip moves by 32.95 mm.
// On a map its vertices are good to 1e-9 m only, in elements of 3.5 mm.
StaticSolver light_rib(const Vector3d& corner, int elements, double load)
{
  const Lattice lattice({straight_line(corner, corner + Vector3d(0.28, 0, 0), elements,
                                       beam_section({3e-3, 0.76e-3, 2e9, 0.4, 910}))});
  StaticOptions options;
  StaticSolver solver(lattice, options);
  solver.clamp({0});
  solver.add_load(elements, {0, 0, -load}, {0, 0, 0});
  solver.solve();
  return solver;
}

TEST(LoadSteps, RibOnAMapBends)
{
  const double near = light_rib({0, 0, 0}, 80, 1e-3).displacement(80).norm();
  EXPECT_NEAR(near, 32.95e-3, 0.03e-3);
  const StaticSolver far = light_rib({5e5, 5e6, 0}, 80, 1e-3);
  EXPECT_NEAR(far.displacement(80).norm(), near, 1e-6 * near);
  EXPECT_NEAR(far.position(80).y(), 5e6, 1e-3);
  EXPECT_NEAR(far.reaction(0)[2], 1e-3, 1e-9);
  EXPECT_LT(far.imbalance(), 1e-8);
}

// Answered in proportion, or refused: never by zero.
TEST(LoadSteps, SmallLoadsAreAnswered)
{
  const double unit = -33.34; // L^3/(3 EI) [m/N]
  int answered = 0;
  for (const double load : {1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) try {
      const StaticSolver solver = light_rib({0, 0, 0}, 20, load);
      EXPECT_NEAR(solver.displacement(20).z() / load, unit, 0.01 * std::abs(unit)) << load;
      EXPECT_NEAR(solver.reaction(0)[2], load, 1e-6 * load);
      ++answered;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("rounding"), std::string::npos) << error.what();
    }
  EXPECT_GE(answered, 4);
}
} // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return RUN_ALL_TESTS();
}
