// Random bent lattices: is the explicit integrator bounded at 0.99 of its stable step, and is that
// step more than half of the true limit? Usage: reliability_bent_lattices [LATTICES] [SEED].
//
// Each lattice has ribs of a random rectangle in each direction, two to eight elements a rib,
// plain or default elements, spherical or true inertia; it is held at one edge and bent by random
// loads in equilibrium (static solver). The true limit is 2/omega of the exact tangent there.

// GCC 12 warns in its own header about undefined operands of vector intrinsics (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "fem/beam/beam_tangent.h"
#include "fem/explicit/explicit_dynamics.h"
#include "fem/layouts/biaxial_layout.h"
#include "fem/statics/static_solver.h"
#include "fem/statics/turns.h"

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

class Dice
{
public:
  explicit Dice(unsigned int seed) : generator_(seed) {}
  double even(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  double decades(double low, double high) { return std::exp(even(std::log(low), std::log(high))); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
  bool coin() { return whole(0, 1) == 1; }
  Vector3d vector() { return {even(-1, 1), even(-1, 1), even(-1, 1)}; }

private:
  std::mt19937 generator_;
};

Lattice random_lattice(Dice& dice)
{
  BiaxialLayout layout;
  layout.apertures_along = dice.whole(1, 2);
  layout.apertures_across = dice.whole(1, 2);
  layout.pitch_along = 0.05 * dice.even(1, 2);
  layout.pitch_across = 0.05 * dice.even(1, 2);
  layout.elements_per_rib = dice.whole(2, 8);
  for (RibSection* section : {&layout.section_along, &layout.section_across})
    *section = {dice.decades(1e-3, 8e-3), dice.decades(5e-4, 4e-3), 2e9, dice.even(0, 0.45), 910};
  return Lattice(rib_lines(layout));
}

// Highest omega^2 with the clamped nodes held.
double highest(const Lattice& lattice, const DynamicsOptions& options, const StaticState& state,
               const std::vector<int>& clamped)
{
  const int n = 6 * lattice.n_nodes();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = stiffness;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const auto& node = lattice.element(e).node;
    const BeamTangent tangent =
        beam_tangent(beam_constants(lattice, e, options.rbf), state.end_positions(e),
                     state.end_orientations(e), {Vector3d::Zero(), Vector3d::Zero()});
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        stiffness.block<6, 6>(6 * node[a], 6 * node[b]) +=
            tangent.stiffness.block<6, 6>(6 * a, 6 * b);
  }
  const auto nodes = lump_inertia(lattice, options.spherical_inertia);
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Eigen::Matrix3d turn = state.orientation[i].toRotationMatrix();
    mass.block<3, 3>(6 * i, 6 * i) = nodes[i].mass * Eigen::Matrix3d::Identity();
    mass.block<3, 3>(6 * i + 3, 6 * i + 3) = turn * nodes[i].tensor * turn.transpose();
  }
  for (const int i : clamped) {
    stiffness.middleRows(6 * i, 6).setZero();
    stiffness.middleCols(6 * i, 6).setZero();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      0.5 * (stiffness + stiffness.transpose()), mass, Eigen::EigenvaluesOnly);
  return modes.eigenvalues().maxCoeff();
}

// Whether small random motion stays small over 4000 steps.
bool is_bounded(ExplicitDynamics& dynamics, double h)
{
  const auto speed = [&] {
    double sum = 0;
    for (int i = 0; i < dynamics.lattice().n_nodes(); ++i) sum += dynamics.velocity(i).norm();
    return sum;
  };
  double early = 0, late = 0;
  for (int i = 0; i < 4000; ++i) {
    dynamics.step(h);
    if (i % 10 != 9) continue;
    const double now = speed();
    if (!std::isfinite(now)) return false;
    (i < 400 ? early : late) = std::max(i < 400 ? early : late, now);
  }
  return late < 30 * early;
}

struct Result {
  bool bent = false, bounded = false;
  double ratio = 0, straight = 0, turn = 0; // bound, and that of straight ribs, over the true limit
};

Result one(Dice& dice)
{
  Result result;
  const Lattice lattice = random_lattice(dice);
  DynamicsOptions options;
  options.rbf = dice.whole(0, 3) > 0;
  options.spherical_inertia = dice.coin();
  StaticOptions statics;
  statics.rbf = options.rbf;
  statics.load_steps = 4;
  StaticSolver solver(lattice, statics);
  const std::vector<int> clamped = lattice.front_edge_nodes();
  solver.clamp(clamped);
  const double size = lattice.box().diagonal().norm();
  double softest = 1e300;
  for (int e = 0; e < lattice.n_elements(); ++e)
    softest = std::min({softest, lattice.section(e).bending_2, lattice.section(e).bending_3});
  std::vector<Vector3d> loads(lattice.n_nodes(), Vector3d::Zero());
  const double strength = dice.decades(1, 100) * softest / (size * size);
  for (int k = dice.whole(1, 4); k > 0; --k) {
    const int node = dice.whole(0, lattice.n_nodes() - 1);
    loads[node] += strength * dice.vector();
  }
  for (int i = 0; i < lattice.n_nodes(); ++i) solver.add_load(i, loads[i], {0, 0, 0});
  try {
    solver.solve();
  } catch (const std::runtime_error&) {
    return result;
  }
  result.turn = sharpest_element(solver.state()).turn;
  if (result.turn < 0.05 || result.turn > 0.8 || solver.stability() != Stability::stable)
    return result;
  result.bent = true;
  ExplicitDynamics dynamics(lattice, options);
  dynamics.clamp(clamped);
  LatticeState state = dynamics.state();
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    state.position[i] = solver.position(i);
    state.orientation[i] = solver.orientation(i);
    state.velocity[i] = 1e-9 * dice.vector();
    dynamics.add_nodal_load(i, loads[i], {0, 0, 0});
  }
  const double straight_step = dynamics.stable_step();
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const SectionForces f = solver.section_forces(e);
    state.largest_force =
        std::max(state.largest_force, Vector3d(f.axial, f.shear_2, f.shear_3).norm());
  }
  dynamics.set_state(state);
  const double limit = 2 / std::sqrt(highest(lattice, options, solver.state(), clamped));
  result.ratio = dynamics.stable_step() / limit;
  result.straight = straight_step / limit;
  result.bounded = is_bounded(dynamics, 0.99 * dynamics.stable_step());
  return result;
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const int wanted = argc > 1 ? std::atoi(argv[1]) : 500;
  const int seed = argc > 2 ? std::atoi(argv[2]) : 1;
  int bent = 0, tries = 0, growing = 0, above = 0, wasteful = 0, straight_above = 0;
  double smallest = 1e300, largest = 0, straight_largest = 0;
  for (; bent < wanted; ++tries) {
    Dice dice(1000003u * static_cast<unsigned int>(seed) + static_cast<unsigned int>(tries));
    const Result r = one(dice);
    if (!r.bent) continue;
    ++bent;
    growing += !r.bounded;
    above += r.ratio > 1;
    wasteful += r.ratio < 0.5;
    straight_above += r.straight > 1;
    smallest = std::min(smallest, r.ratio);
    largest = std::max(largest, r.ratio);
    straight_largest = std::max(straight_largest, r.straight);
    if (!r.bounded || r.ratio > 1 || r.ratio < 0.5)
      std::printf("lattice %d: bound/limit %.4f, straight bound/limit %.3f, turn %.3f rad, %s\n",
                  tries, r.ratio, r.straight, r.turn, r.bounded ? "bounded" : "grows");
  }
  std::printf("%d bent lattices of %d drawn, seed %d: %d grow, %d bounds above the limit, %d below "
              "half of it; bound/limit %.3f to %.3f\n"
              "bound of straight ribs: %d above the limit, up to %.2f\n",
              bent, tries, seed, growing, above, wasteful, smallest, largest, straight_above,
              straight_largest);
  return growing + above + wasteful > 0 ? 1 : 0;
}
