// Natural frequencies against beam theory. Where the modes of the discrete beam are sines too, its
// own frequencies follow from a two-by-two problem and have to come out to the digits of the
// eigenvalue solver; elsewhere the frequencies have to converge to those of the continuous beam
// with order two, the error of lumped masses. Fails when tangent, inertia, supports or the choice
// of modes are wrong, or when a mode is missed or spurious.
#include "fem/implicit/modes.h"
#include "fem/lattice/lumped_inertia.h"
#include "fem/layouts/biaxial_layout.h"
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Length 1, line density 1, bending stiffness 1 and 2; stretch and shear do not matter to 1e-5.
BeamSection slender()
{
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e7;
  section.torsion = 1e3;
  section.bending_2 = 2;
  section.bending_3 = 1;
  section.line_density = 1;
  section.rotary_1 = 2e-8;
  section.rotary_2 = section.rotary_3 = 1e-8;
  return section;
}

Lattice straight(int n, const BeamSection& section, double length = 1)
{
  return Lattice({straight_line({0, 0, 0}, {length, 0, 0}, n, section)});
}

void fix(StaticState& state, int node, const std::vector<int>& components)
{
  for (const int c : components) state.supports.push_back({node, c, 0.});
}

// Leaves only displacements along x and y and rotation about z.
void keep_in_plane(StaticState& state)
{
  for (int i = 0; i < state.lattice.n_nodes(); ++i) fix(state, i, {2, 3, 4});
}

std::vector<double> circular(const std::vector<NaturalMode>& modes)
{
  std::vector<double> omega;
  for (const NaturalMode& mode : modes) omega.push_back(2 * M_PI * mode.frequency);
  return omega;
}

// Square of the lower circular frequency at which nodes move by W sin(k x) sideways and turn by T
// cos(k x): of each element of length h at stretch a = 1 + N/EA, to second order, the strain energy
// per length is
//   S (W q - a c T)^2/2 + EI q^2 T^2/2 + N (c q T W - a c^2 T^2/2)
// with q = 2 sin(k h/2)/h and c = cos(k h/2), times the square of a sine.
double bending_square(double shear, double bending, double rotary, double density, double h,
                      double k, double tension = 0, double stretch = 1)
{
  const double q = 2 * std::sin(0.5 * k * h) / h, c = std::cos(0.5 * k * h);
  const double a = shear * q * q / density;
  const double b = -(stretch * shear - tension) * c * q / std::sqrt(density * rotary);
  const double d = (stretch * (stretch * shear - tension) * c * c + bending * q * q) / rotary;
  // Product over sum: no cancellation.
  return (a * d - b * b) / (0.5 * (a + d) + std::sqrt(0.25 * (a - d) * (a - d) + b * b));
}

// Circular frequency of waves of stretch or twist, u = sin(k x).
double wave_frequency(double stiffness, double inertia, double h, double k)
{
  return std::sqrt(stiffness / inertia) * 2 * std::sin(0.5 * k * h) / h;
}

// A polypropylene rib with both ends pinned and kept from turning about its axis: every mode of it,
// in both planes, of twist and of stretch, and no other one.
TEST(Frequencies, PinnedRibHasAllModesOfTheDiscreteBeam)
{
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.3, 910});
  const double length = 0.065;
  const int n = 16;
  const double h = length / n;
  for (const bool rbf : {false, true}) {
    StaticState state(straight(n, rib, length));
    fix(state, 0, {0, 1, 2, 3});
    fix(state, n, {0, 1, 2, 3});
    const double shear_2 = rbf ? residual_shear(rib.shear_2, rib.bending_3, h) : rib.shear_2;
    const double shear_3 = rbf ? residual_shear(rib.shear_3, rib.bending_2, h) : rib.shear_3;
    std::vector<double> expected;
    for (int i = 1; i < n; ++i) {
      const double k = i * M_PI / length;
      expected.push_back(
          std::sqrt(bending_square(shear_2, rib.bending_3, rib.rotary_3, rib.line_density, h, k)));
      expected.push_back(
          std::sqrt(bending_square(shear_3, rib.bending_2, rib.rotary_2, rib.line_density, h, k)));
      expected.push_back(wave_frequency(rib.torsion, rib.rotary_1, h, k));
      expected.push_back(wave_frequency(rib.axial, rib.line_density, h, k));
    }
    std::sort(expected.begin(), expected.end());
    const std::vector<double> omega = circular(natural_modes(state, 24, rbf));
    for (int i = 0; i < 24; ++i) EXPECT_NEAR(omega[i], expected[i], 1e-10 * expected[i]) << i;
  }
}

// Euler-Bernoulli frequency times 1 - x, x = (n pi r/L)^2 (1 + E/(k G))/2, to first order in x. The
// element with residual bending flexibility is of fourth order here.
TEST(Frequencies, RotaryInertiaAndShearLowerThePinnedRib)
{
  const BeamSection rib = beam_section({5e-3, 5e-3, 2.4e9, 0.3, 910});
  const double length = 0.13;
  const int n = 32;
  StaticState state(straight(n, rib, length));
  fix(state, 0, {0, 1});
  fix(state, n, {1});
  keep_in_plane(state);
  const std::vector<double> omega = circular(natural_modes(state, 3));
  for (int i = 1; i <= 3; ++i) {
    const double k = i * M_PI / length, radius_square = rib.rotary_3 / rib.line_density;
    const double x = 0.5 * k * k * radius_square * (1 + rib.axial / rib.shear_2);
    const double slender = k * k * std::sqrt(rib.bending_3 / rib.line_density);
    EXPECT_NEAR(omega[i - 1], slender * (1 - x), slender * (2 * x * x + 1e-5)) << i;
  }
}

enum class Ends { cantilever, clamped, free };

// Squares of beta L from the plane modes, without rigid ones.
std::vector<double> plane_bending(Ends ends, int n, int count, bool rbf)
{
  StaticState state(straight(n, slender()));
  if (ends != Ends::free) fix(state, 0, {0, 1, 5});
  if (ends == Ends::clamped) fix(state, n, {0, 1, 5});
  keep_in_plane(state);
  const int rigid = ends == Ends::free ? 3 : 0;
  std::vector<double> omega = circular(natural_modes(state, count + rigid, rbf));
  omega.erase(omega.begin(), omega.begin() + rigid);
  return omega;
}

// The term of order h^2 goes by extrapolation from two meshes; what is left is of order h^4.
void expect_second_order(Ends ends, const std::vector<double>& beta)
{
  const int count = static_cast<int>(beta.size());
  const std::vector<double> coarse = plane_bending(ends, 16, count, false),
                            middle = plane_bending(ends, 32, count, false),
                            fine = plane_bending(ends, 64, count, false);
  for (int i = 0; i < count; ++i) {
    const double exact = beta[i] * beta[i], wave = beta[i] / 64;
    EXPECT_NEAR(std::log2((coarse[i] - middle[i]) / (middle[i] - fine[i])), 2, 0.15) << i;
    EXPECT_NEAR(fine[i], exact, 0.25 * wave * wave * exact + 1e-5 * exact) << i;
    EXPECT_NEAR((4 * fine[i] - middle[i]) / 3, exact, (2 * std::pow(wave, 4) + 2e-5) * exact) << i;
  }
}

TEST(Frequencies, CantileverConvergesWithOrderTwo)
{
  expect_second_order(Ends::cantilever, {1.8751041, 4.6940911, 7.8547574, 10.9955407});
}

TEST(Frequencies, ClampedBeamConvergesWithOrderTwo)
{
  expect_second_order(Ends::clamped, {4.7300407, 7.8532046, 10.9956078});
}

TEST(Frequencies, FreeBeamConvergesWithOrderTwo)
{
  expect_second_order(Ends::free, {4.7300407, 7.8532046, 10.9956078});
}

// With residual bending flexibility lumped masses make the whole error: of order two at a free end,
// of order four (trapezoidal rule without boundary terms) between clamps.
TEST(Frequencies, OrderOfTheDefaultElement)
{
  for (const auto& [ends, beta, order] :
       {std::tuple{Ends::cantilever, 1.8751041, 2.}, std::tuple{Ends::clamped, 4.7300407, 4.}}) {
    double omega[3];
    for (int k = 0; k < 3; ++k) omega[k] = plane_bending(ends, 8 << k, 1, true)[0];
    const double measured = std::log2((omega[0] - omega[1]) / (omega[1] - omega[2]));
    EXPECT_GT(measured, order - 0.1);
    EXPECT_LT(measured, order + 0.4);
    const double last = (omega[2] - omega[1]) / (std::exp2(order) - 1);
    EXPECT_NEAR(omega[2] + last, beta * beta, 1e-5 * beta * beta);
  }
}

// Unsupported, in space: six rigid motions, then bending in both planes. How near to zero: rounding
// of the highest eigenvalue (some 1e-16 of it) against the square of the lowest bending frequency.
TEST(Frequencies, FreeRibHasSixRigidModes)
{
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.3, 910});
  const double length = 0.26;
  const StaticState state(straight(32, rib, length));
  const std::vector<double> omega = circular(natural_modes(state, 8));
  const double wave = 4.7300407 / length;
  const double first = wave * wave * std::sqrt(rib.bending_2 / rib.line_density);
  for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(omega[i]), 1e-4 * first) << i;
  EXPECT_NEAR(omega[6], first, 5e-3 * first);
}

// Stretch and twist of a rib fixed at one end: (2 i - 1) pi/(2 L) sqrt(stiffness/inertia), lowered
// by the share (k h)^2/24.
TEST(Frequencies, AxialAndTorsional)
{
  const BeamSection rib = beam_section({5e-3, 2.5e-3, 2.4e9, 0.3, 910});
  const double length = 0.065;
  const int n = 20;
  const double h = length / n;
  for (const bool twist : {false, true}) {
    StaticState state(straight(n, rib, length));
    fix(state, 0, {0, 3});
    for (int i = 0; i <= n; ++i) {
      fix(state, i, {1, 2, 4, 5});
      fix(state, i, {twist ? 0 : 3});
    }
    const double stiffness = twist ? rib.torsion : rib.axial;
    const double inertia = twist ? rib.rotary_1 : rib.line_density;
    const std::vector<double> omega = circular(natural_modes(state, 4));
    for (int i = 0; i < 4; ++i) {
      const double k = (i + 0.5) * M_PI / length, exact = k * std::sqrt(stiffness / inertia);
      EXPECT_NEAR(omega[i], wave_frequency(stiffness, inertia, h, k), 1e-8 * exact);
      EXPECT_NEAR(omega[i], exact * (1 - k * k * h * h / 24), exact * std::pow(k * h, 4) / 1000);
    }
  }
}

// Square of the circular frequencies of a pinned beam under a tension that a static solution has
// brought on.
std::vector<double> tensioned(int n, double tension, bool rbf, int count)
{
  StaticOptions options;
  options.rbf = rbf;
  options.load_steps = 1;
  StaticSolver solver(straight(n, slender()), options);
  for (const int c : {0, 1}) solver.prescribe(0, c, 0);
  solver.prescribe(n, 1, 0);
  for (int i = 0; i <= n; ++i)
    for (const int c : {2, 3, 4}) solver.prescribe(i, c, 0);
  solver.add_load(n, {tension, 0, 0}, {0, 0, 0});
  solver.solve();
  std::vector<double> square;
  for (const double omega : circular(natural_modes(solver.state(), count, rbf)))
    square.push_back(std::copysign(omega * omega, omega));
  return square;
}

// From beam (T = 0) to string (T = 1000 EI/L^2), under compression below and above the buckling
// load pi^2 EI/L^2: omega^2 = k^2 (T + EI k^2)/m, negative where the straight beam is unstable.
TEST(Frequencies, TensionedBeam)
{
  const int n = 32;
  const BeamSection section = slender();
  for (const double tension : {0., 10., 1000., -0.5 * M_PI * M_PI, -1.2 * M_PI * M_PI}) {
    const double stretch = 1 + tension / section.axial;
    const std::vector<double> plain = tensioned(n, tension, false, 4),
                              bowed = tensioned(n, tension, true, 4);
    for (int i = 0; i < 4; ++i) {
      const double k = (i + 1) * M_PI, exact = k * k * (tension + k * k);
      const double discrete = bending_square(section.shear_2, section.bending_3, section.rotary_3,
                                             section.line_density, 1. / n, k, tension, stretch);
      EXPECT_NEAR(plain[i], discrete, 2e-7 * std::abs(exact)) << tension;
      // Fourth order of the bowed element, and the stretch.
      EXPECT_NEAR(bowed[i], exact,
                  (std::pow(k / n, 4) + 2 * std::abs(tension) / section.axial + 1e-5) * k * k *
                      (std::abs(tension) + k * k))
          << tension;
    }
  }
}

// Two equal ribs that cross at their middles, pinned at their ends: in the lowest mode they move
// together, as each would alone. Needs the junction to carry the masses of both.
TEST(Frequencies, CrossedRibsMoveAsOne)
{
  const BeamSection section = slender();
  const int n = 8;
  StaticState state(Lattice({straight_line({-0.5, 0, 0}, {0.5, 0, 0}, n, section),
                             straight_line({0, -0.5, 0}, {0, 0.5, 0}, n, section)}));
  for (int l = 0; l < 2; ++l) {
    const std::vector<int> nodes = state.lattice.nodes_of_line(l);
    for (const int end : {nodes.front(), nodes.back()}) fix(state, end, {0, 1, 2});
  }
  const double shear = residual_shear(section.shear_3, section.bending_2, 1. / n);
  const double expected = std::sqrt(bending_square(shear, section.bending_2, section.rotary_2,
                                                   section.line_density, 1. / n, M_PI));
  const std::vector<NaturalMode> modes = natural_modes(state, 6);
  // Others are lower: bending in the plane, where each rib is softer.
  const auto out_of_plane = std::find_if(modes.begin(), modes.end(), [&](const NaturalMode& mode) {
    return std::abs(mode.shape[state.lattice.nearest_node({0, 0, 0})][2]) > 0.1;
  });
  ASSERT_NE(out_of_plane, modes.end());
  EXPECT_NEAR(2 * M_PI * out_of_plane->frequency, expected, 1e-6 * expected);
}

// A square section bends alike in both planes: every bending frequency comes twice. The next mode
// is of twist.
TEST(Frequencies, SquareRibHasPairs)
{
  const BeamSection rib = beam_section({5e-3, 5e-3, 2.4e9, 0.3, 910});
  const int n = 16;
  StaticState state(straight(n, rib, 0.13));
  fix(state, 0, {0, 1, 2, 3});
  fix(state, n, {1, 2});
  const std::vector<double> omega = circular(natural_modes(state, 4));
  for (int i = 0; i < 4; ++i) {
    const double k = (i / 2 + 1) * M_PI / 0.13;
    const double shear = residual_shear(rib.shear_2, rib.bending_2, 0.13 / n);
    const double expected = std::sqrt(
        bending_square(shear, rib.bending_2, rib.rotary_2, rib.line_density, 0.13 / n, k));
    EXPECT_NEAR(omega[i], expected, 1e-8 * expected) << i;
  }
}

// A free lattice that floats turned in space has the same frequencies; modes are orthogonal with
// respect to the turned inertia and have modal mass 1.
TEST(Frequencies, SameInAnyAttitude)
{
  BiaxialLayout layout;
  layout.apertures_along = 2;
  layout.apertures_across = 1;
  layout.pitch_along = layout.pitch_across = 0.065;
  layout.elements_per_rib = 4;
  layout.section_along = layout.section_across = {5e-3, 2.5e-3, 2.4e9, 0.3, 910};
  StaticState state{Lattice(rib_lines(layout))};
  const std::vector<double> flat = circular(natural_modes(state, 12));
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(2, Vector3d(1, 2, -1).normalized()));
  for (int i = 0; i < state.lattice.n_nodes(); ++i) {
    state.position[i] = turn * state.position[i] + Vector3d(0.1, 0.2, 0.3);
    state.orientation[i] = turn;
  }
  const std::vector<NaturalMode> modes = natural_modes(state, 12);
  const std::vector<double> turned = circular(modes);
  for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(turned[i]), 1e-3 * flat[6]) << i;
  for (int i = 6; i < 12; ++i) EXPECT_NEAR(turned[i], flat[i], 1e-6 * flat[i]) << i;

  const std::vector<NodeInertia> nodes = lump_inertia(state.lattice, false);
  const Eigen::Matrix3d r = turn.toRotationMatrix();
  for (const int a : {6, 7})
    for (const int b : {6, 7}) {
      double product = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto &u = modes[a].shape[i], &v = modes[b].shape[i];
        product += nodes[i].mass * u.head<3>().dot(v.head<3>()) +
                   u.tail<3>().dot(r * nodes[i].tensor * r.transpose() * v.tail<3>());
      }
      EXPECT_NEAR(product, a == b ? 1 : 0, 1e-7);
    }
}

TEST(Frequencies, RefusesNoModes)
{
  const StaticState state(straight(2, slender()));
  EXPECT_THROW(natural_modes(state, 0), std::invalid_argument);
  EXPECT_THROW(natural_modes(state, 19), std::invalid_argument);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
