// Ribs under tension, as a pull-out makes them: sideways stiffness and frequency grow with the
// tension and the rib stays straight, however large the tension is against the bending stiffness of
// one element. Fails when the residual bending flexibility comes without its bowing: sections then
// tip over at a tension of S*, see fem/ribs/beam_section.h.
#include "fem/explicit/explicit_dynamics.h"
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

BeamSection slender()
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e7;
  section.torsion = section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  section.rotary_1 = section.rotary_2 = section.rotary_3 = 1e-6;
  return section;
}

// Both ends clamped, one of them free to slide under the tension T; a small load P at the centre.
double deflection(int n, double tension, double load)
{
  const Lattice lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())});
  StaticOptions options;
  options.load_steps = 4;
  StaticSolver solver(lattice, options);
  solver.clamp({0});
  for (const int freedom : {1, 2, 3, 4, 5}) solver.prescribe(n, freedom, 0);
  solver.add_load(n, {tension, 0, 0}, {0, 0, 0});
  solver.add_load(n / 2, {0, 0, load}, {0, 0, 0});
  solver.solve();
  return solver.displacement(n / 2).z();
}

// E I w'''' = T w'': w = P (k a - 2 tanh(k a/2))/(2 T k) with k^2 = T/EI and half the length a.
double exact_deflection(double tension, double load)
{
  const double k = std::sqrt(tension), a = 0.5;
  return load * (k * a - 2 * std::tanh(0.5 * k * a)) / (2 * tension * k);
}

// Fourth order while the boundary layer sqrt(EI/T) is resolved; 2000 is two and a half times the S*
// of the coarsest mesh.
TEST(TensionedBeam, DeflectionUnderACentralLoad)
{
  const double load = 1e-4;
  for (const auto& [tension, coarse, fine] :
       {std::array<double, 3>{10, 1e-4, 2e-5}, {200, 4e-3, 4e-4}, {2000, 3e-2, 4e-3}}) {
    const double exact = exact_deflection(tension, load);
    EXPECT_NEAR(deflection(8, tension, load), exact, coarse * exact) << tension;
    EXPECT_NEAR(deflection(16, tension, load), exact, fine * exact) << tension;
  }
}

// pi^2 EI/L^2 for pinned ends: the load sideways that a column under half of it bears is amplified
// by 1/(1 - 1/2), to the accuracy of the first buckling mode.
TEST(TensionedBeam, CompressionSoftens)
{
  const int n = 8;
  const double critical = M_PI * M_PI;
  double sideways[2];
  for (const int compressed : {0, 1}) {
    StaticSolver solver(Lattice({straight_line({0, 0, 0}, {1, 0, 0}, n, slender())}), {});
    for (const int freedom : {0, 1, 2, 3}) solver.prescribe(0, freedom, 0);
    for (const int freedom : {1, 2}) solver.prescribe(n, freedom, 0);
    if (compressed) solver.add_load(n, {-0.5 * critical, 0, 0}, {0, 0, 0});
    const double load = 1e-4;
    for (int i = 1; i < n; ++i)
      solver.add_load(i, {0, 0, load * std::sin(M_PI * i / n)}, {0, 0, 0});
    solver.solve();
    sideways[compressed] = solver.displacement(n / 2).z();
  }
  EXPECT_NEAR(sideways[1] / sideways[0], 2, 1e-3);
}

// A polypropylene rib at 15 % of stretch, twice the S* of its elements, plucked.
TEST(TensionedBeam, StaysStraightWhileItVibrates)
{
  const double length = 0.13, stretch = 0.15, pluck = 1e-5;
  const int n = 16;
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.3, 910});
  ASSERT_GT(stretch * rib.axial, 2 * residual_shear(rib.shear_3, rib.bending_2, length / n));
  const Lattice lattice({straight_line({0, 0, 0}, {length, 0, 0}, n, rib)});
  ExplicitDynamics dynamics(lattice, {});
  dynamics.clamp({0, n});
  LatticeState state = dynamics.state();
  for (int i = 0; i <= n; ++i) {
    const double sine = std::sin(M_PI * i / n);
    state.position[i] = {(1 + stretch) * length * i / n, 0.5 * pluck * sine, pluck * sine};
  }
  dynamics.set_state(state);
  dynamics.step(1e-9);
  const double h = 0.9 * dynamics.stable_step(), start = dynamics.energies().ledger();
  double widest = 0;
  for (int step = 0; step < 20000; ++step) {
    dynamics.step(h);
    widest = std::max(widest, dynamics.position(n / 2).tail<2>().norm());
  }
  EXPECT_LT(widest, 1.3 * pluck);
  EXPECT_NEAR(dynamics.energies().ledger(), start, 1e-6 * start);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
