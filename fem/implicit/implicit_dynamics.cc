#include "fem/implicit/implicit_dynamics.h"

#include "fem/beam/beam_tangent.h"
#include "fem/beam/section_forces.h"
#include "fem/lattice/beam_constants.h"
#include "fem/statics/resting_supports.h"

#include <Eigen/Eigenvalues>

#include <stdexcept>
#include <string>
#include <utility>

namespace interlock::fem
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Every node needs mass and rotary inertia about each axis, or its acceleration is not determined.
void require_inertia(const Lattice& lattice, const std::vector<NodeInertia>& nodes)
{
  for (int e = 0; e < lattice.n_elements(); ++e)
    for (const int node : lattice.element(e).node) {
      const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(nodes[node].tensor,
                                                              Eigen::EigenvaluesOnly);
      if (!(nodes[node].mass > 0) || !(principal.eigenvalues()[0] > 0))
        throw std::invalid_argument("Rib line " + std::to_string(lattice.element(e).line) +
                                    " has no mass or no rotary inertia, which implicit dynamics "
                                    "needs (given_section completes a section).");
    }
}

// Velocity and acceleration of a support at time zero, from its first three places.
std::array<double, 2> derivatives(const ImplicitDynamics::MotionFunction& value, double delta)
{
  const double first = value(0), second = value(delta), third = value(2 * delta);
  return {(4 * second - 3 * first - third) / (2 * delta),
          (first - 2 * second + third) / (delta * delta)};
}
} // namespace

ImplicitDynamics::ImplicitDynamics(const StaticState& start, const ImplicitOptions& options,
                                   MPI_Comm communicator)
    : options_(options), motion_{start, std::vector<Rates>(start.lattice.n_nodes()),
                                 std::vector<Rates>(start.lattice.n_nodes())},
      nodes_(lump_inertia(start.lattice, false)),
      loads_at_([held = start.reached_loads](double, Loads& loads) { loads = held; }),
      system_(motion_.state, options.rbf, communicator)
{
  if (!(options.spectral_radius >= 0 && options.spectral_radius <= 1))
    throw std::invalid_argument("The spectral radius of implicit dynamics is " +
                                std::to_string(options.spectral_radius) +
                                " but must be between 0 and 1.");
  require_inertia(start.lattice, nodes_);
  for (const StaticState::Support& support : resting_supports(start))
    prescribe(support.node, support.component, [here = support.value](double) { return here; });
  loads_ = loads_at(0);
  reactions_ = reactions();
}

void ImplicitDynamics::set_loads(const LoadFunction& loads)
{
  loads_at_ = loads;
}

void ImplicitDynamics::prescribe(int node, int component, const MotionFunction& value)
{
  if (step_)
    throw std::runtime_error("A support of implicit dynamics was set at time " +
                             std::to_string(time_) + " s but must be set before the first step.");
  for (Support& support : supports_)
    if (support.node == node && support.component == component) {
      support.value = value;
      return;
    }
  supports_.push_back({node, component, value});
}

void ImplicitDynamics::set_motion(int node, const Vector3d& velocity, const Vector3d& spin)
{
  motion_.translation.at(node).velocity = velocity;
  motion_.rotation[node].velocity = motion_.state.orientation[node].conjugate() * spin;
}

ImplicitDynamics::Loads ImplicitDynamics::loads_at(double time) const
{
  Loads loads(nodes_.size(), NodeLoad::Zero());
  loads_at_(time, loads);
  return loads;
}

// Inertia force plus internal force minus loads and weight: at supports what they exert, elsewhere
// zero.
ImplicitDynamics::Loads ImplicitDynamics::reactions() const
{
  const StaticState& state = motion_.state;
  const Lattice& lattice = state.lattice;
  Loads sum(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    sum[i] = inertia_force(nodes_[i], {state.orientation[i], Vector3d::Zero(),
                                       motion_.translation[i], motion_.rotation[i]}) -
             loads_[i];
    sum[i].head<3>() -= nodes_[i].mass * options_.gravity;
  }
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const Eigen::Matrix<double, 12, 1> force =
        beam_force(beam_constants(lattice, e, options_.rbf), state.end_positions(e),
                   state.end_orientations(e));
    for (int v = 0; v < 2; ++v) sum[lattice.element(e).node[v]] += force.segment<6>(6 * v);
  }
  return sum;
}

// Rates of the supports from their functions, accelerations of all else from what is unbalanced.
void ImplicitDynamics::start(double h)
{
  std::vector<std::array<bool, 6>> fixed(nodes_.size(), std::array<bool, 6>{});
  Loads prescribed(nodes_.size(), NodeLoad::Zero());
  for (const Support& support : supports_) {
    const int node = support.node, c = support.component;
    const auto [velocity, acceleration] = derivatives(support.value, 0.5 * h);
    fixed[node][c] = true;
    prescribed[node][c] = acceleration;
    Vector3d spin = this->spin(node);
    (c < 3 ? motion_.translation[node].velocity[c] : spin[c - 3]) = velocity;
    motion_.rotation[node].velocity = motion_.state.orientation[node].conjugate() * spin;
  }
  loads_ = loads_at(0);
  const Loads unbalanced = reactions();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    start_node(static_cast<int>(i), fixed[i], prescribed[i], unbalanced[i]);
  reactions_ = reactions();
  set_supports(h);
  step_ = std::make_unique<DynamicStep>(motion_, nodes_, system_, options_.max_iterations,
                                        options_.step_tolerance);
}

// `unbalanced`: force and torque with the gyroscopic one, but without accelerations.
void ImplicitDynamics::start_node(int node, const std::array<bool, 6>& fixed,
                                  const NodeLoad& prescribed, const NodeLoad& unbalanced)
{
  const Matrix3d turn = motion_.state.orientation[node].toRotationMatrix();
  Eigen::Matrix<double, 6, 6> inertia = Eigen::Matrix<double, 6, 6>::Zero();
  inertia.topLeftCorner<3, 3>().diagonal().setConstant(nodes_[node].mass);
  inertia.bottomRightCorner<3, 3>() = turn * nodes_[node].tensor * turn.transpose();
  NodeLoad right = -unbalanced;
  for (int c = 0; c < 6; ++c)
    if (fixed[c]) {
      inertia.row(c) = NodeLoad::Unit(c);
      right[c] = prescribed[c];
    }
  const NodeLoad acceleration = inertia.partialPivLu().solve(right);
  Rates &translation = motion_.translation[node], &rotation = motion_.rotation[node];
  translation.acceleration = translation.averaged = acceleration.head<3>();
  rotation.acceleration = rotation.averaged = turn.transpose() * acceleration.tail<3>();
}

void ImplicitDynamics::set_supports(double h)
{
  std::vector<StaticState::Support> at_end;
  for (const Support& support : supports_) {
    double value = support.value(time_ + h);
    if (support.component >= 3) value -= support.value(time_);
    at_end.push_back({support.node, support.component, value});
  }
  system_.set_supports(at_end);
}

int ImplicitDynamics::step(double h)
{
  if (!step_) start(h);
  set_supports(h);
  const GeneralisedAlpha rule(options_.spectral_radius, h);
  const Loads end_loads = loads_at(time_ + h);
  Loads with_weight = end_loads;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    with_weight[i].head<3>() += nodes_[i].mass * options_.gravity;
  const DynamicStep::Outcome outcome = step_->solve(rule, with_weight);
  if (outcome.reason <= 0)
    throw std::runtime_error("Newton's method stopped in the step of " + std::to_string(h) +
                             " s after time " + std::to_string(time_) + " s after " +
                             std::to_string(outcome.iterations) +
                             " iterations: " + SNESConvergedReasons[outcome.reason] + ".");
  accept(rule, outcome.solution, end_loads);
  time_ += h;
  return outcome.iterations;
}

// Work by the mean of the forces at both ends of the step.
void ImplicitDynamics::accept(const GeneralisedAlpha& rule, const dealii::Vector<double>& x,
                              Loads end_loads)
{
  StaticState& state = motion_.state;
  const Loads increment = increments(state, x);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Vector3d move = increment[i].head<3>(), turn = increment[i].tail<3>();
    Rates &translation = motion_.translation[i], &rotation = motion_.rotation[i];
    translation = advanced(rule, translation, move);
    rotation = advanced(rule, rotation, state.orientation[i].conjugate() * turn);
  }
  state.advance(x);
  const Loads before = std::exchange(loads_, std::move(end_loads));
  const Loads reactions_before = std::exchange(reactions_, reactions());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    load_work_ += 0.5 * (before[i] + loads_[i]).dot(increment[i]);
  for (const Support& support : supports_) {
    const int node = support.node, c = support.component;
    support_work_ += 0.5 * (reactions_before[node][c] + reactions_[node][c]) * increment[node][c];
  }
}

ImplicitEnergies ImplicitDynamics::energies() const
{
  const StaticState& state = motion_.state;
  ImplicitEnergies energies;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Vector3d& spin = motion_.rotation[i].velocity;
    energies.kinetic += 0.5 * (nodes_[i].mass * motion_.translation[i].velocity.squaredNorm() +
                               spin.dot(nodes_[i].tensor * spin));
    energies.gravitational -= nodes_[i].mass * options_.gravity.dot(state.world_position(i));
  }
  for (int e = 0; e < state.lattice.n_elements(); ++e) {
    const BeamConstants<double> beam = beam_constants(state.lattice, e, options_.rbf);
    energies.elastic += strain_energy(
        beam_strains(beam_ends(state.end_positions(e), state.end_orientations(e)), beam), beam);
  }
  energies.load_work = load_work_;
  energies.support_work = support_work_;
  return energies;
}

Vector3d ImplicitDynamics::momentum() const
{
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sum += nodes_[i].mass * motion_.translation[i].velocity;
  return sum;
}

Vector3d ImplicitDynamics::angular_momentum() const
{
  const StaticState& state = motion_.state;
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sum += state.world_position(i).cross(nodes_[i].mass * motion_.translation[i].velocity) +
           state.orientation[i] * (nodes_[i].tensor * motion_.rotation[i].velocity);
  return sum;
}
} // namespace interlock::fem
