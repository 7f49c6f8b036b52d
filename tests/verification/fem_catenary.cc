// A beam without bending stiffness worth the name hangs as a cable. Fails when the stiffness from
// tension is wrong, or when repeated loading forgets what is already there.
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// `n` equal chords of a circular arc that hangs down from (0, 0) to (1, 0), together `length` long.
RibLine hanging_arc(int n, double length, const BeamSection& section)
{
  // n chords of angle t each: sin(n t/2)/sin(t/2) = n/length, whose left side falls with t.
  double low = 0, high = 2 * M_PI / n;
  while (high - low > 1e-15) {
    const double t = 0.5 * (low + high);
    (std::sin(0.5 * n * t) / std::sin(0.5 * t) > n / length ? low : high) = t;
  }
  const double t = low, radius = 0.5 * length / n / std::sin(0.5 * t);
  RibLine arc;
  arc.section = section;
  for (int i = 0; i <= n; ++i) {
    const double angle = t * (i - 0.5 * n);
    arc.points.emplace_back(0.5 + radius * std::sin(angle),
                            radius * (std::cos(0.5 * n * t) - std::cos(angle)), 0);
  }
  return arc;
}

struct Cable {
  double sag, tension; // tension at the support over the weight per length
};

Cable hang(int n, double length)
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e7;
  section.torsion = section.bending_2 = section.bending_3 = 1e-6;
  section.line_density = 1;
  const Lattice lattice({hanging_arc(n, length, section)});
  StaticOptions options;
  options.load_steps = 1;
  StaticSolver solver(lattice, options);
  for (const int end : {0, n})
    for (const int freedom : {0, 1, 2, 3, 4}) solver.prescribe(end, freedom, 0);
  // Newton's method needs some tension before it takes the rest, so the weight grows from that at
  // which bending still carries a part of it.
  double weight = 0;
  for (double next = 1e-5; weight < 1; next = std::min(1., 2 * next)) {
    for (int i = 0; i <= n; ++i) {
      const double share = (i == 0 || i == n ? 0.5 : 1) * length / n;
      solver.add_load(i, {0, -(next - weight) * share, 0}, {0, 0, 0});
    }
    weight = next;
    solver.solve();
  }
  return {-solver.position(n / 2).y(), solver.reaction(0).head<3>().norm()};
}

// Inextensible cable: a = H/w from length = 2 a sinh(1/(2 a)), span 1. A polygon of n chords lies
// off the curve by O((length/n)^2); what is left after extrapolation is the bending stiffness,
// EI/(w a^3) in units of the span, and the fourth power of the chord. EA/(w L) = 1e7.
TEST(Catenary, SagAndTension)
{
  struct Row {
    double length, a, sag, tension;
  };
  for (const Row& row : {Row{1.05, 0.9196396, 0.1393042, 1.0589438},
                         {1.10, 0.6549639, 0.2003008, 0.8552647},
                         {1.50, 0.3082365, 0.5026333, 0.8108697}}) {
    const Cable coarse = hang(20, row.length), fine = hang(40, row.length);
    const double bending = 1e-6 / std::pow(row.a, 3), chord = row.length / 20;
    const auto expect = [&](double at_20, double at_40, double exact) {
      EXPECT_NEAR(at_40, exact, chord * chord / 4) << row.length;
      EXPECT_NEAR(std::log2((at_20 - exact) / (at_40 - exact)), 2, 0.4) << row.length;
      EXPECT_NEAR((4 * at_40 - at_20) / 3, exact, bending + std::pow(chord, 4)) << row.length;
    };
    expect(coarse.sag, fine.sag, row.sag);
    expect(coarse.tension, fine.tension, row.tension);
  }
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
