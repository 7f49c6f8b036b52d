#include "fem/statics/static_solver.h"

#include "fem/beam/beam_tangent.h"
#include "fem/statics/arc_length.h"
#include "fem/statics/load_step.h"
#include "fem/statics/negative_pivots.h"
#include "fem/statics/static_elements.h"

#include <petscsys.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
void require_petsc()
{
  PetscBool running = PETSC_FALSE;
  PetscInitialized(&running);
  if (running == PETSC_FALSE)
    throw std::runtime_error(
        "The static solver needs PETSc: create a dealii::Utilities::MPI::MPI_InitFinalize first.");
}

// The arc length steps to and fro along the path, which history does not allow.
void require_elastic(const Lattice& lattice)
{
  for (int l = 0; l < lattice.n_lines(); ++l) {
    const BeamSection& section = lattice.line(l).section;
    if (section.softening > 0 || std::isfinite(section.yield_force))
      throw std::runtime_error("The arc-length method follows elastic ribs, but rib line " +
                               std::to_string(l) + " softens or yields.");
  }
}

// Loads and supports on the way from those of `state` to what is set, after `share` of the way, of
// which this step makes `part`.
struct Ramp {
  std::vector<NodeLoad> loads;
  std::vector<StaticState::Support> supports;
};

Ramp ramp(const StaticState& state, double share, double part)
{
  Ramp now{state.reached_loads, state.supports};
  for (std::size_t i = 0; i < now.loads.size(); ++i)
    now.loads[i] += share * (state.loads[i] - state.reached_loads[i]);
  for (StaticState::Support& support : now.supports) {
    const int c = support.component;
    const double start =
        c < 3 ? (state.position[support.node] - state.lattice.reference_position(support.node))[c]
              : support.reached;
    support.value =
        c < 3 ? start + share * (support.value - start) : part * (support.value - start);
  }
  return now;
}

// Largest angle by which a node turns between two states [rad].
double largest_turn(const StaticState& from, const StaticState& to)
{
  double largest = 0;
  for (std::size_t i = 0; i < from.orientation.size(); ++i)
    largest = std::max(largest, from.orientation[i].angularDistance(to.orientation[i]));
  return largest;
}

// On the stable branch a step turns no node by more: Newton's method may reach any branch from
// afar, the mirror image of a buckled rib as well as the rib itself [rad].
constexpr double longest_turn = 0.5;

// A load step that does not converge is halved, up to six times.
constexpr int finest = 64;

std::string refusal(const LoadStep::Outcome& outcome, double step, int n_steps)
{
  std::ostringstream text;
  if (outcome.singular())
    text << "The lattice is not held: it can move as a rigid body or a mechanism, after load step "
         << step << " of " << n_steps
         << "; or the linear solver that statics_ options chose does not converge.";
  else
    text << "Newton's method stopped after load step " << step << " of " << n_steps
         << ", after halving it six times: " << SNESConvergedReasons[outcome.reason] << " after "
         << outcome.iterations << " iterations.";
  return text.str();
}
} // namespace

StaticSolver::StaticSolver(const Lattice& lattice, const StaticOptions& options)
    : state_(lattice), options_(options)
{
  if (options.order != 1 && options.order != 2)
    throw std::invalid_argument("The order of the elements is " + std::to_string(options.order) +
                                " but must be 1 or 2.");
  if (options.order == 2) state_.pairs = quadratic_pairs(lattice);
}

void StaticSolver::clamp(const std::vector<int>& nodes)
{
  for (const int node : nodes)
    for (int c = 0; c < 6; ++c) prescribe(node, c, 0);
}

void StaticSolver::pin(const std::vector<int>& nodes)
{
  for (const int node : nodes)
    for (int c = 0; c < 3; ++c) prescribe(node, c, 0);
}

void StaticSolver::prescribe(int node, int component, double value)
{
  for (StaticState::Support& support : state_.supports)
    if (support.node == node && support.component == component) {
      support.value = value;
      return;
    }
  state_.supports.push_back({node, component, value});
}

void StaticSolver::add_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
{
  state_.loads.at(node).head<3>() += force;
  state_.loads[node].tail<3>() += moment;
}

int StaticSolver::solve()
{
  require_petsc();
  require_held(state_);
  LatticeSystem system(state_, options_.rbf, options_.communicator);
  LoadStep step(system, state_, options_);
  int iterations = 0;
  const StaticState start = state_;
  const double all = static_cast<double>(finest) * options_.load_steps; // of the finest steps
  for (int done = 0, stride = finest; done < all;) {
    const Ramp now = ramp(start, (done + stride) / all, stride / all);
    const LoadStep::Outcome outcome = step.solve(now.loads, now.supports);
    iterations += outcome.iterations;
    factorisations_ += outcome.factorisations;
    if (outcome.reason <= 0) {
      stride /= 2;
      if (outcome.singular() || stride == 0)
        throw std::runtime_error(
            refusal(outcome, static_cast<double>(done) / finest, options_.load_steps));
      continue;
    }
    const StaticState before = options_.stable_branch ? state_ : start;
    state_.advance(step.solution());
    state_.commit_plastic_stretch(options_.rbf);
    state_.reached_loads = now.loads;
    for (std::size_t s = 0; s < now.supports.size(); ++s)
      if (now.supports[s].component >= 3) state_.supports[s].reached += now.supports[s].value;
    if (options_.stable_branch) {
      const int unstable = fem::unstable_directions(system, state_);
      const bool doubtful = unstable > 0 || largest_turn(before, state_) > longest_turn;
      if (doubtful && unstable_ == 0 && stride > 1) {
        state_ = before;
        stride /= 2;
        continue;
      }
      unstable_ = unstable;
      unstable_on_the_way_ = std::max(unstable_on_the_way_, unstable);
    }
    done += stride;
    if (stride < finest && done % (2 * stride) == 0) stride *= 2;
  }
  return iterations;
}

std::vector<PathPoint> StaticSolver::trace_path(const ArcLengthOptions& arc_length)
{
  require_petsc();
  require_held(state_);
  require_elastic(state_.lattice);
  return ArcLength(state_, options_, arc_length).trace();
}

SectionForces StaticSolver::section_forces(int e) const
{
  if (!state_.pairs.empty()) {
    const QuadraticPair& pair = state_.pairs[e / 2];
    return fem::section_forces(pair.beam, at_nodes(state_.position, pair.node),
                               at_nodes(state_.orientation, pair.node))[e % 2];
  }
  return fem::section_forces(
      beam_constants(state_.lattice, e, options_.rbf, state_.plastic_stretch[e]),
      state_.end_positions(e), state_.end_orientations(e));
}

double StaticSolver::strain_energy() const
{
  double sum = 0;
  for (int e = 0; e < n_elements(state_); ++e)
    with_element(state_, options_.rbf, e, [&](const auto& beam, const auto& nodes) {
      sum += fem::strain_energy(beam, at_nodes(state_.position, nodes),
                                at_nodes(state_.orientation, nodes));
    });
  for (int s = 0; s < state_.lattice.n_springs(); ++s) {
    const RotationalSpring& spring = state_.lattice.spring(s);
    sum += spring_energy(spring,
                         {state_.orientation[spring.node[0]], state_.orientation[spring.node[1]]});
  }
  return sum;
}

NodeLoad StaticSolver::reaction(int node) const
{
  const Lattice& lattice = state_.lattice;
  NodeLoad sum = NodeLoad::Zero();
  // Joined nodes take the force together, each its own moment.
  for (const int joined : lattice.joined_nodes(node)) {
    NodeLoad own = -state_.reached_loads.at(joined);
    for (int e = 0; e < n_elements(state_); ++e)
      with_element(state_, options_.rbf, e, [&](const auto& beam, const auto& nodes) {
        for (std::size_t v = 0; v < nodes.size(); ++v)
          if (nodes[v] == joined)
            own += beam_force(beam, at_nodes(state_.position, nodes),
                              at_nodes(state_.orientation, nodes))
                       .template segment<6>(6 * v);
      });
    sum.head<3>() += own.head<3>();
    if (joined == node) sum.tail<3>() += own.tail<3>();
  }
  for (int s = 0; s < lattice.n_springs(); ++s) {
    const RotationalSpring& spring = lattice.spring(s);
    const Eigen::Vector3d moment = spring_moment(
        spring, {state_.orientation[spring.node[0]], state_.orientation[spring.node[1]]});
    if (spring.node[0] == node) sum.tail<3>() -= moment;
    if (spring.node[1] == node) sum.tail<3>() += moment;
  }
  return sum;
}
} // namespace interlock::fem
