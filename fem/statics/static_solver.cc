#include "fem/statics/static_solver.h"

#include "fem/beam/beam_tangent.h"
#include "fem/ribs/number_text.h"
#include "fem/statics/arc_length.h"
#include "fem/statics/balance.h"
#include "fem/statics/last_correction.h"
#include "fem/statics/load_step.h"
#include "fem/statics/negative_pivots.h"
#include "fem/statics/static_elements.h"
#include "fem/statics/turns.h"

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

// Share of the largest displacement that the last Newton step may change.
constexpr double largest_uncertainty = 1e-6;

// A load step that fails is halved, up to ten times; one that may have left the branch, up to six.
constexpr int finest = 1024, doubt_ends = finest / 64;

void require_node(const Lattice& lattice, int node, const std::string& what)
{
  if (node < 0 || node >= lattice.n_nodes())
    throw std::invalid_argument(what + " is meant for node " + std::to_string(node) +
                                ", but the nodes are 0 to " +
                                std::to_string(lattice.n_nodes() - 1) + ".");
}

void require_options(const StaticOptions& options)
{
  const auto require = [](bool fine, const std::string& name, const std::string& value,
                          const std::string& allowed) {
    if (!fine) throw std::invalid_argument(name + " is " + value + " but must be " + allowed + ".");
  };
  require(options.order == 1 || options.order == 2, "The order of the elements",
          std::to_string(options.order), "1 or 2");
  require(options.load_steps > 0, "The number of load steps", std::to_string(options.load_steps),
          "at least 1");
  require(options.max_iterations > 0, "The number of Newton iterations of a load step",
          std::to_string(options.max_iterations), "at least 1");
  require(options.step_tolerance > 0, "The tolerance of the Newton step",
          number_text(options.step_tolerance), "positive");
}

// Why there is no equilibrium after `step` of `n_steps` load steps.
std::string refusal(const StaticState& state, const LoadStep::Outcome& outcome, bool has_moved,
                    double step, int n_steps)
{
  double stiffest = 0, largest = 0; // [N]
  for (int e = 0; e < state.lattice.n_elements(); ++e)
    stiffest = std::max(stiffest, state.lattice.section(e).axial);
  for (const NodeLoad& load : state.loads)
    largest = std::max(largest, load.head<3>().lpNorm<Eigen::Infinity>());
  std::ostringstream text;
  if (largest > stiffest)
    text << "The loads are too large: a node carries " << largest
         << " N, but the stiffest rib would be twice as long under " << stiffest << " N.";
  else if (outcome.singular && !has_moved)
    text << "The lattice is not held: it can move as a rigid body or a mechanism, after load step "
         << step << " of " << n_steps
         << "; or the linear solver that statics_ options chose does not converge.";
  else if (outcome.singular)
    text << "The tangent stiffness is singular after load step " << step << " of " << n_steps
         << ", after halving it ten times: the path ends or branches there.";
  else
    text << "Newton's method stopped after load step " << step << " of " << n_steps
         << ", after halving it ten times: " << SNESConvergedReasons[outcome.reason] << " after "
         << outcome.iterations << " iterations.";
  return text.str();
}

std::string sharp_refusal(const SharpestElement& sharp, const Lattice& lattice)
{
  const LatticeElement& element = lattice.element(sharp.element);
  return "Element " + std::to_string(element.place) + " of rib line " +
         std::to_string(element.line) + " turns by " + number_text(sharp.turn) +
         " rad between its ends, but only up to " + number_text(largest_element_turn) +
         " rad are right: the rib folds up there, or needs shorter elements.";
}
} // namespace

StaticSolver::StaticSolver(const Lattice& lattice, const StaticOptions& options)
    : lattice_(lattice), state_(lattice), options_(options)
{
  require_options(options);
  if (options.order == 2) state_.pairs = quadratic_pairs(state_.lattice);
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
  require_node(lattice_, node, "A support");
  if (component < 0 || component > 5)
    throw std::invalid_argument("Freedom " + std::to_string(component) + " of node " +
                                std::to_string(node) +
                                " is prescribed, but a node has the freedoms 0 to 5.");
  if (!std::isfinite(value))
    throw std::invalid_argument("Freedom " + std::to_string(component) + " of node " +
                                std::to_string(node) + " is prescribed as " + number_text(value) +
                                ", but its value must be finite.");
  for (StaticState::Support& support : state_.supports)
    if (support.node == node && support.component == component) {
      support.value = value;
      return;
    }
  state_.supports.push_back({node, component, value});
}

void StaticSolver::add_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
{
  require_node(lattice_, node, "A load");
  if (!force.allFinite() || !moment.allFinite())
    throw std::invalid_argument("The load of node " + std::to_string(node) + " is " +
                                point_text(force) + " N with " + point_text(moment) +
                                " N m, but loads must be finite.");
  state_.loads[node].head<3>() += force;
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
  jumped_ = false;
  for (int done = 0, stride = finest; done < all;) {
    const Ramp now = ramp(start, (done + stride) / all, stride / all);
    const LoadStep::Outcome outcome = step.solve(now.loads, now.supports);
    iterations += outcome.iterations;
    factorisations_ += outcome.factorisations;
    if (outcome.reason <= 0) {
      stride /= 2;
      if (stride == 0)
        throw std::runtime_error(refusal(state_, outcome, has_moved_,
                                         static_cast<double>(done) / finest, options_.load_steps));
      continue;
    }
    const StaticState before = state_;
    state_.advance(step.solution());
    const Judgement judgement = judge(before, system, stride);
    if (judgement != Judgement::right) {
      const SharpestElement sharp = sharpest_element(state_);
      state_ = before;
      stride /= 2;
      if (stride == 0) throw std::runtime_error(sharp_refusal(sharp, lattice_));
      continue;
    }
    state_.commit_plastic_stretch(options_.rbf);
    state_.reached_loads = now.loads;
    for (std::size_t s = 0; s < now.supports.size(); ++s)
      if (now.supports[s].component >= 3) state_.supports[s].reached += now.supports[s].value;
    has_moved_ = true;
    done += stride;
    if (stride < finest && done % (2 * stride) == 0) stride *= 2;
  }
  require_balance(system);
  return iterations;
}

// Newton's method may reach any branch from afar, the mirror image of a buckled rib or a rib folded
// up in one element as well as the rib itself.
StaticSolver::Judgement StaticSolver::judge(const StaticState& before, LatticeSystem& system,
                                            int stride)
{
  if (sharpest_element(state_).turn > largest_element_turn) return Judgement::astray;
  const bool jumps = largest_turn(before, state_) > options_.longest_turn;
  const bool may_halve = unstable_ <= 0 && stride > doubt_ends;
  if (jumps && may_halve) return Judgement::astray;
  if (options_.stable_branch) {
    const int unstable = fem::unstable_directions(system, state_);
    if (unstable > 0 && may_halve) return Judgement::astray;
    unstable_ = unstable;
    unstable_on_the_way_ = std::max(unstable_on_the_way_, unstable);
  }
  jumped_ = jumped_ || jumps;
  return Judgement::right;
}

void StaticSolver::require_balance(LatticeSystem& system)
{
  const auto share = [this] {
    const Balance now = balance(state_, options_.rbf, correction_);
    largest_forces_ = std::max(largest_forces_, now.scale);
    return largest_forces_ > 0 ? now.error / largest_forces_ : 0.;
  };
  for (int i = 0; i < lattice_.n_nodes(); ++i)
    largest_displacement_ = std::max(largest_displacement_, displacement(i).norm());
  correction_.clear();
  imbalance_ = share();
  uncertainty_ = 0;
  constexpr double rounding = 1e-10; // below, the forces need no correction
  if (imbalance_ > rounding) {
    const LastCorrection last = last_correction(system, state_, options_.rbf);
    correction_ = last.forces;
    imbalance_ = share();
    if (largest_displacement_ > 0) uncertainty_ = last.displacement / largest_displacement_;
  }
  if (!(uncertainty_ <= largest_uncertainty))
    throw std::runtime_error("The displacements are uncertain by " + number_text(uncertainty_) +
                             " of the largest, but at most " + number_text(largest_uncertainty) +
                             " may be: loads that strain the ribs by so little drown in rounding.");
  if (!(imbalance_ <= options_.largest_imbalance))
    throw std::runtime_error("Reactions and loads do not balance: " + number_text(imbalance_) +
                             " of the forces is left, but at most " +
                             number_text(options_.largest_imbalance) +
                             " may be; loads that strain the ribs by so little drown in rounding.");
}

Stability StaticSolver::stability()
{
  int unstable = unstable_;
  if (!options_.stable_branch) {
    LatticeSystem system(state_, options_.rbf, options_.communicator);
    unstable = fem::unstable_directions(system, state_);
  }
  // Moments that keep their direction are no gradient: then the symmetric part of the tangent is
  // enough to say stable, but not to say unstable.
  const bool has_moments =
      std::any_of(state_.reached_loads.begin(), state_.reached_loads.end(),
                  [](const NodeLoad& load) { return load.tail<3>().norm() > 0; });
  if (unstable < 0 || jumped_ || (unstable > 0 && has_moments)) return Stability::not_known;
  return unstable > 0 ? Stability::unstable : Stability::stable;
}

std::vector<PathPoint> StaticSolver::trace_path(const ArcLengthOptions& arc_length)
{
  require_petsc();
  require_held(state_);
  require_elastic(state_.lattice);
  correction_.clear();
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
  require_node(lattice_, node, "A reaction");
  const std::vector<NodeLoad> forces = unbalanced_forces(state_, options_.rbf, correction_);
  NodeLoad sum = NodeLoad::Zero();
  // Joined nodes take the force together, each its own moment.
  for (const int joined : lattice_.joined_nodes(node)) sum.head<3>() += forces[joined].head<3>();
  sum.tail<3>() += forces[node].tail<3>();
  return sum;
}
} // namespace interlock::fem
