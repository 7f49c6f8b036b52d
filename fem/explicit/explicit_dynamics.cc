// Set-up, state and queries of the explicit integrator; the step itself is in explicit_step.cc.
#include "fem/explicit/explicit_dynamics.h"

#include "fem/explicit/wide.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
// Entries xx yy zz xy xz yz of a symmetric matrix.
std::array<double, 6> packed(const Eigen::Matrix3d& a)
{
  return {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(0, 2), a(1, 2)};
}

void require_size(std::size_t size, int expected, const char* name, const char* owners = "nodes")
{
  if (size != static_cast<std::size_t>(expected))
    throw std::invalid_argument("A lattice state holds " + std::to_string(size) + " entries of " +
                                name + " but the lattice has " + std::to_string(expected) + " " +
                                owners + ".");
}

void require_node(int node, int n_nodes)
{
  if (node < 0 || node >= n_nodes)
    throw std::invalid_argument("Node " + std::to_string(node) +
                                " is to be clamped or loaded, but the nodes are 0 to " +
                                std::to_string(n_nodes - 1) + ".");
}
} // namespace

ExplicitDynamics::ExplicitDynamics(const Lattice& lattice, const DynamicsOptions& options)
    : lattice_(lattice), options_(options),
      nodes_(lump_inertia(lattice, options.spherical_inertia)),
      frequency_(beam_frequency(lattice, nodes_, options.spherical_inertia, options.rbf))
{
  if (lattice.n_springs() > 0)
    throw std::invalid_argument("The explicit integrator takes lattices with rigid junctions only, "
                                "but this one has " +
                                std::to_string(lattice.n_springs()) +
                                " rotational springs at its junctions.");
  number_slots();
  size_lanes();
  fill_beam_constants();
  fill_node_constants();
  move_all_blocks();
  for (int s = 0; s < n_slots_; ++s)
    for (int c = 0; c < 3; ++c) position_[c][s] = lattice_.reference_position(slot_node_[s])[c];
}

void ExplicitDynamics::number_slots()
{
  node_slot_.assign(lattice_.n_nodes(), -1);
  const auto add_slot = [&](int node) {
    if (node_slot_[node] < 0) node_slot_[node] = n_slots_;
    slot_node_.push_back(node);
    ++n_slots_;
  };
  for (int e = 0; e < lattice_.n_elements(); ++e) {
    const LatticeElement& element = lattice_.element(e);
    if (e == 0 || element.line != lattice_.element(e - 1).line) add_slot(element.node[0]);
    element_slot_.push_back(n_slots_ - 1);
    add_slot(element.node[1]);
  }
  for (const std::vector<int>& slots : slots_of_nodes())
    if (slots.size() > 1) junction_slots_.push_back(slots);
}

std::vector<std::vector<int>> ExplicitDynamics::slots_of_nodes() const
{
  std::vector<std::vector<int>> slots(lattice_.n_nodes());
  for (int s = 0; s < n_slots_; ++s) slots[slot_node_[s]].push_back(s);
  return slots;
}

void ExplicitDynamics::size_lanes()
{
  n_padded_ = (n_slots_ + wide_lanes - 1) / wide_lanes * wide_lanes;
  // One block more at either side: reading slot s + 1, and the element that ends at slot s.
  const std::size_t size = n_padded_ + 2 * wide_lanes;
  const auto clear = [&](Lane& lane) { lane.assign(size, 0.); };
  const auto clear_all = [&](auto&... lanes) {
    (std::for_each(lanes.begin(), lanes.end(), clear), ...);
  };
  clear_all(position_, velocity_, spin_, angular_momentum_, orientation_, inertia_,
            inverse_inertia_, load_force_, load_torque_, beam_force_, beam_torque1_, beam_torque2_,
            force_, torque_, clamp_force_);
  for (Lane* lane :
       {&mass_, &inverse_mass_, &clamped_, &counts_, &clamp_work_, &load_work_, &damping_loss_})
    clear(*lane);
  std::fill(orientation_[0].begin(), orientation_[0].end(), 1.);
  beams_.resize(size);
  bent_.resize(size);
}

void ExplicitDynamics::fill_beam_constants()
{
  for (int e = 0; e < lattice_.n_elements(); ++e) {
    const BeamConstants<double> beam = beam_constants(lattice_, e, options_.rbf);
    beams_.set(element_slot_[e], beam);
    bent_.set(element_slot_[e], lattice_, e, nodes_, options_.spherical_inertia, options_.rbf);
    softens_ = softens_ || beam.softening > 0 || std::isfinite(beam.yield_stretch);
  }
}

void ExplicitDynamics::fill_node_constants()
{
  for (const NodeInertia& node : nodes_) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(node.tensor,
                                                                   Eigen::EigenvaluesOnly);
    smallest_inertia_.push_back(principal.eigenvalues()[0]);
  }
  for (int s = 0; s < n_slots_; ++s) {
    const NodeInertia& node = nodes_[slot_node_[s]];
    mass_[s] = node.mass;
    inverse_mass_[s] = 1 / node.mass;
    counts_[s] = node_slot_[slot_node_[s]] == s ? 1 : 0;
    const auto tensor = packed(node.tensor), inverse = packed(node.tensor.inverse());
    for (int c = 0; c < 6; ++c) {
      inertia_[c][s] = tensor[c];
      inverse_inertia_[c][s] = inverse[c];
    }
  }
}

void ExplicitDynamics::clear_loads()
{
  for (const int s : loaded_slots_)
    for (int c = 0; c < 3; ++c) load_force_[c][s] = load_torque_[c][s] = 0;
  loaded_slots_.clear();
}

void ExplicitDynamics::add_nodal_load(int node, const Eigen::Vector3d& force,
                                      const Eigen::Vector3d& moment)
{
  require_node(node, lattice_.n_nodes());
  add_slot_load(node_slot_[node], force, moment);
}

void ExplicitDynamics::clamp(const std::vector<int>& nodes)
{
  std::vector<bool> is_clamped(lattice_.n_nodes(), false);
  for (const int node : nodes) {
    require_node(node, lattice_.n_nodes());
    is_clamped[node] = true;
  }
  for (int s = 0; s < n_slots_; ++s) clamped_[s] = is_clamped[slot_node_[s]] ? 1 : 0;
  all_clamped_ = std::find(is_clamped.begin(), is_clamped.end(), false) == is_clamped.end();
}

void ExplicitDynamics::clamp_all()
{
  std::fill_n(clamped_.begin(), n_slots_, 1.);
  all_clamped_ = true;
}

void ExplicitDynamics::step(double h)
{
  const double kick = 0.5 * (previous_step_ + h);
  // The rigid geogrid does not deform, so its elements exert no force in sum.
  if (!all_clamped_ && softens_)
    compute_element_loads<Tension::softening>();
  else if (!all_clamped_)
    compute_element_loads<Tension::linear>();
  sum_at_slots(!all_clamped_);
  sum_at_junctions();
  if (options_.spherical_inertia)
    update_nodes<true>(kick, h);
  else
    update_nodes<false>(kick, h);
  previous_step_ = h;
}

Eigen::Vector3d ExplicitDynamics::clamp_reaction() const
{
  Eigen::Vector3d sum(0, 0, 0);
  for (int s = 0; s < n_slots_; ++s) sum += vector_at(clamp_force_, s);
  return sum;
}

LatticeExtremes ExplicitDynamics::extremes(bool with_bends) const
{
  return {largest_force_, largest_plastic_stretch_,
          with_bends ? bent_.largest(beams_, position_, orientation_, clamped_, moved_) : 0};
}

SectionForces ExplicitDynamics::section_forces(int e) const
{
  const int s = element_slot_[e];
  return fem::section_forces(constants(e), {vector_at(position_, s), vector_at(position_, s + 1)},
                             {quaternion_at(s), quaternion_at(s + 1)});
}

LatticeState ExplicitDynamics::state() const
{
  LatticeState state;
  for (int i = 0; i < lattice_.n_nodes(); ++i) {
    state.position.push_back(position(i));
    state.orientation.push_back(orientation(i));
    state.velocity.push_back(velocity(i));
    state.spin.push_back(spin(i));
    if (!options_.spherical_inertia)
      state.angular_momentum.push_back(vector_at(angular_momentum_, node_slot_[i]));
  }
  if (softens_)
    for (int e = 0; e < lattice_.n_elements(); ++e)
      state.plastic_stretch.push_back(plastic_stretch(e));
  const auto of_slots = [this](const Lane& lane) {
    return std::vector<double>(lane.begin(), lane.begin() + n_slots_);
  };
  state.clamp_work = of_slots(clamp_work_);
  state.load_work = of_slots(load_work_);
  state.damping_loss = of_slots(damping_loss_);
  state.previous_step = previous_step_;
  state.largest_force = largest_force_;
  return state;
}

void ExplicitDynamics::set_state(const LatticeState& state)
{
  const int n = lattice_.n_nodes();
  require_size(state.position.size(), n, "position");
  require_size(state.orientation.size(), n, "orientation");
  require_size(state.velocity.size(), n, "velocity");
  require_size(state.spin.size(), n, "spin");
  if (!options_.spherical_inertia)
    require_size(state.angular_momentum.size(), n, "angular momentum");
  // Ribs that were linear before have no plastic stretch.
  const bool has_stretch = softens_ && !state.plastic_stretch.empty();
  if (has_stretch)
    require_size(state.plastic_stretch.size(), lattice_.n_elements(), "plastic stretch",
                 "elements");
  const auto to_slots = [this](const std::vector<double>& from, const char* name, Lane& lane) {
    require_size(from.size(), n_slots_, name, "slots");
    std::copy(from.begin(), from.end(), lane.begin());
  };
  to_slots(state.clamp_work, "clamp work", clamp_work_);
  to_slots(state.load_work, "load work", load_work_);
  to_slots(state.damping_loss, "damping loss", damping_loss_);
  for (int s = 0; s < n_slots_; ++s) {
    const int node = slot_node_[s];
    const Eigen::Quaterniond& q = state.orientation[node];
    for (int c = 0; c < 3; ++c) {
      position_[c][s] = state.position[node][c];
      velocity_[c][s] = state.velocity[node][c];
      spin_[c][s] = state.spin[node][c];
      if (!options_.spherical_inertia) angular_momentum_[c][s] = state.angular_momentum[node][c];
      orientation_[c + 1][s] = q.vec()[c];
    }
    orientation_[0][s] = q.w();
  }
  largest_plastic_stretch_ = 0;
  for (int e = 0; e < lattice_.n_elements(); ++e) {
    const double stretch = has_stretch ? state.plastic_stretch[e] : 0;
    beams_.plastic_stretch[element_slot_[e]] = stretch;
    largest_plastic_stretch_ = std::max(largest_plastic_stretch_, stretch);
  }
  previous_step_ = state.previous_step;
  largest_force_ = state.largest_force;
}
} // namespace interlock::fem
