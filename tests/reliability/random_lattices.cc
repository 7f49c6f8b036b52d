// Random lattices at rest: right, or refused in one sentence? Usage: reliability_random_lattices
// [LATTICES] [SEED].
//
// Ribs, bent lines and meshes of both with random sections whose stiffnesses spread over four
// decades, anywhere within 10^6 m, under loads over ten decades from far below to above what bends
// them by their length. Right means: the displacements of a second solver, Newton's method with
// dense Gaussian elimination (Eigen) about the origin, in steps of its own, within 1e-6 of the
// largest displacement, and reactions that balance the loads.
#include "fem/beam/beam_tangent.h"
#include "fem/lattice/beam_constants.h"
#include "fem/statics/static_solver.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

struct Problem {
  std::vector<RibLine> lines; // about zero
  Vector3d place{0, 0, 0};
  std::vector<std::pair<Vector3d, Vector3d>> loads; // where, force
  Vector3d held{0, 0, 0};
};

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
  Vector3d vector() { return {even(-1, 1), even(-1, 1), even(-1, 1)}; }

private:
  std::mt19937 generator_;
};

BeamSection random_section(Dice& dice)
{
  BeamSection section;
  section.bending_2 = dice.decades(1e-2, 1e2);
  section.bending_3 = section.bending_2 * dice.decades(0.1, 10);
  section.torsion = section.bending_2 * dice.decades(0.1, 1);
  section.axial = 1e4 * dice.decades(1e-2, 1e2) * std::max(section.bending_2, section.bending_3);
  section.shear_2 = section.shear_3 = 0.4 * section.axial;
  section.line_density = 1;
  return section;
}

Problem random_problem(Dice& dice)
{
  Problem problem;
  const int layout = dice.whole(0, 2);
  const int n = dice.whole(2, 8);
  if (layout == 0) {
    problem.lines = {straight_line({0, 0, 0}, {1, dice.even(-1, 1), 0}, n, random_section(dice))};
  } else if (layout == 1) { // an arc
    RibLine arc;
    arc.section = random_section(dice);
    const double angle = dice.even(0.3, 3);
    for (int i = 0; i <= 2 * n; ++i)
      arc.points.emplace_back(std::sin(angle * i / (2 * n)), 1 - std::cos(angle * i / (2 * n)), 0);
    problem.lines = {arc};
  } else { // two ribs along, two across
    const BeamSection along = random_section(dice), across = random_section(dice);
    for (const double y : {0., 1.})
      problem.lines.push_back(straight_line({0, y, 0}, {2, y, 0}, 2 * n, along));
    for (const double x : {1., 2.})
      problem.lines.push_back(straight_line({x, 0, 0}, {x, 1, 0}, n, across));
    problem.held = {0, 1, 0};
  }
  double softest = 1e300;
  for (const RibLine& line : problem.lines)
    softest = std::min({softest, line.section.bending_2, line.section.bending_3});
  const Vector3d tip = problem.lines[0].points.back();
  problem.loads = {{tip, softest * dice.decades(1e-9, 10) * dice.vector()}};
  if (dice.whole(0, 1) == 1) problem.place = dice.decades(1, 1e6) * dice.vector();
  return problem;
}

std::vector<RibLine> moved(std::vector<RibLine> lines, const Vector3d& by)
{
  for (RibLine& line : lines)
    for (Vector3d& point : line.points) point += by;
  return lines;
}

// The second solver: positions and orientations of nodes, six freedoms each, dense.
class DenseSolver
{
public:
  DenseSolver(const Lattice& lattice, const std::vector<int>& held, int node, const Vector3d& force)
      : lattice_(lattice), held_(held), node_(node), force_(force)
  {
    for (int i = 0; i < lattice.n_nodes(); ++i) {
      position_.push_back(lattice.reference_position(i));
      orientation_.push_back(Eigen::Quaterniond::Identity());
    }
  }
  // In `steps` equal steps; false where Newton's method does not end.
  bool solve(int steps)
  {
    for (int k = 1; k <= steps; ++k)
      if (!solve_step(static_cast<double>(k) / steps)) return false;
    return true;
  }
  Vector3d displacement(int i) const { return position_[i] - lattice_.reference_position(i); }

private:
  bool solve_step(double share)
  {
    const int n = 6 * lattice_.n_nodes();
    double last = 1e300;
    for (int iteration = 0; iteration < 60; ++iteration) {
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
      Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
      right.segment<3>(6 * node_) = share * force_;
      for (int e = 0; e < lattice_.n_elements(); ++e) {
        const auto& node = lattice_.element(e).node;
        const BeamTangent tangent = beam_tangent(
            beam_constants(lattice_, e, true), {position_[node[0]], position_[node[1]]},
            {orientation_[node[0]], orientation_[node[1]]}, {Vector3d::Zero(), Vector3d::Zero()});
        for (int a = 0; a < 2; ++a) {
          right.segment<6>(6 * node[a]) -= tangent.force.segment<6>(6 * a);
          for (int b = 0; b < 2; ++b)
            stiffness.block<6, 6>(6 * node[a], 6 * node[b]) +=
                tangent.stiffness.block<6, 6>(6 * a, 6 * b);
        }
      }
      for (const int i : held_) {
        stiffness.middleRows(6 * i, 6).setZero();
        stiffness.block<6, 6>(6 * i, 6 * i).setIdentity();
        right.segment<6>(6 * i).setZero();
      }
      const Eigen::VectorXd step = stiffness.partialPivLu().solve(right);
      double size = 0;
      for (int i = 0; i < lattice_.n_nodes(); ++i) {
        position_[i] += step.segment<3>(6 * i);
        orientation_[i] =
            (rotation_exponential(step.segment<3>(6 * i + 3)) * orientation_[i]).normalized();
        size = std::max(size, step.segment<6>(6 * i).norm());
      }
      if (!std::isfinite(size) || size > 1e3) return false;
      if (size < 1e-13 || (size < 1e-9 && size > 0.3 * last)) return true;
      last = size;
    }
    return false;
  }

  const Lattice& lattice_;
  const std::vector<int> held_;
  const int node_;
  const Vector3d force_;
  std::vector<Vector3d> position_;
  std::vector<Eigen::Quaterniond> orientation_;
};

enum class Verdict { right, refused, stray, no_second, wrong };

constexpr bool verbose = false; // name every refusal

Verdict judge(const Problem& problem, int number, double& worst_imbalance, int& unbalanced)
{
  const auto held_nodes = [&](const Lattice& lattice, const Vector3d& place) {
    std::vector<int> nodes{lattice.nearest_node(place)};
    if (problem.held.norm() > 0) nodes.push_back(lattice.nearest_node(place + problem.held));
    return nodes;
  };
  const Lattice near(problem.lines);
  std::vector<Vector3d> found;
  std::string sentence;
  Stability stability = Stability::not_known;
  try {
    const Lattice far(moved(problem.lines, problem.place));
    StaticOptions options;
    StaticSolver solver(far, options);
    solver.clamp(held_nodes(far, problem.place));
    const auto& [where, force] = problem.loads[0];
    solver.add_load(far.nearest_node(problem.place + where), force, {0, 0, 0});
    solver.solve();
    stability = solver.stability();
    worst_imbalance = std::max(worst_imbalance, solver.imbalance());
    unbalanced += solver.imbalance() > 1e-8;
    for (int i = 0; i < far.n_nodes(); ++i) found.push_back(solver.displacement(i));
  } catch (const std::exception& error) {
    sentence = error.what();
    if (sentence.find('\n') == std::string::npos && sentence.back() == '.') {
      if (verbose) std::printf("lattice %d refused: %s\n", number, sentence.c_str());
      return Verdict::refused;
    }
    std::printf("lattice %d: %s\n", number, sentence.c_str());
    return Verdict::wrong;
  }
  const auto& [where, force] = problem.loads[0];
  // From afar the vertices have fewer digits: their last one turns an element by this much.
  const double digits = 1e-15 * problem.place.norm() * near.n_elements();
  double difference = 1e300, size = 0;
  for (const int steps : {20, 200}) {
    DenseSolver second(near, held_nodes(near, {0, 0, 0}), near.nearest_node(where), force);
    if (!second.solve(steps)) continue;
    double now = 0;
    size = 0;
    for (int i = 0; i < near.n_nodes(); ++i) {
      size = std::max(size, second.displacement(i).norm());
      now = std::max(now, (second.displacement(i) - found[i]).norm());
    }
    difference = std::min(difference, now / size);
    if (difference < 1e-6) break;
  }
  if (difference == 1e300) return Verdict::no_second;
  if (difference < 1e-6 + 1e2 * digits) return Verdict::right;
  std::printf("lattice %d: differs by %.1e of %.1e m, %s\n", number, difference, size,
              stability == Stability::stable ? "stable" : "not called stable");
  return stability == Stability::stable ? Verdict::wrong : Verdict::stray;
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const int wanted = argc > 1 ? std::atoi(argv[1]) : 500;
  const int seed = argc > 2 ? std::atoi(argv[2]) : 1;
  int count[5] = {}, unbalanced = 0;
  double worst = 0;
  for (int i = 0; i < wanted; ++i) {
    Dice dice(1000003u * static_cast<unsigned int>(seed) + static_cast<unsigned int>(i));
    ++count[static_cast<int>(judge(random_problem(dice), i, worst, unbalanced))];
  }
  std::printf("%d lattices, seed %d: %d right, %d refused in one sentence, %d on another branch "
              "that is not called stable, %d without an answer of the second solver, %d wrong; "
              "largest imbalance %.1e, %d above 1e-8\n",
              wanted, seed, count[0], count[1], count[2], count[3], count[4], worst, unbalanced);
  return count[4] > 0 ? 1 : 0;
}
