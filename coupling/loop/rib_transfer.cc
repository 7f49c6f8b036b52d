#include "coupling/loop/rib_transfer.h"

#include "dem/exact_sums.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
RibTransfer::RibTransfer(const fem::Lattice& unloaded, const fem::DynamicsOptions& options,
                         const std::vector<int>& clamped, bool rigid, double edge_rounding,
                         const std::optional<RibBox>& box)
    : rigid_(rigid), dynamics_(unloaded, options), node_rates_(unloaded.n_nodes(), 0.),
      is_clamped_(unloaded.n_nodes(), rigid)
{
  if (rigid_)
    dynamics_.clamp_all();
  else
    dynamics_.clamp(clamped);
  for (const int node : clamped) is_clamped_[node] = true;

  std::vector<dem::RibShape> shapes;
  for (int e = 0; e < lattice().n_elements(); ++e) {
    const fem::LatticeElement& element = lattice().element(e);
    dem::RibShape shape;
    shape.line = element.line;
    shape.first_end = dynamics_.first_slot(e);
    shape.half_width = 0.5 * lattice().shape(e).width;
    shape.half_thickness = 0.5 * lattice().shape(e).thickness;
    shape.rounding = edge_rounding;
    for (int end : {0, 1}) {
      const int node = element.node[end];
      shape.inverse_mass[end] = is_clamped_[node] ? 0 : 1 / dynamics_.mass(node);
      shape.width_axis[end] = element.frame * dem::Vector3::UnitY();
    }
    shapes.push_back(shape);
  }
  ribs_ = dem::RibSet(std::move(shapes), dynamics_.n_slots());
  hold_all();
  refresh_ribs();
  if (box) walls_.emplace(*box, ribs_, dynamics_);
}

void RibTransfer::hold_all()
{
  dynamics_.move_all_blocks();
  ribs_.set_all_present();
  clamped_.clear();
  const std::vector<std::vector<int>> slots = dynamics_.slots_of_nodes();
  for (std::size_t node = 0; node < slots.size(); ++node)
    if (is_clamped_[node]) clamped_.insert(clamped_.end(), slots[node].begin(), slots[node].end());
}

void RibTransfer::hold_part(const std::vector<int>& blocks, const std::vector<int>& known)
{
  hold_all();
  dynamics_.move_blocks(blocks);
  std::vector<bool> moved(dynamics_.n_slots(), false);
  const int width = fem::ExplicitDynamics::slots_of_block();
  for (const int block : blocks)
    for (int s = block * width; s < std::min((block + 1) * width, dynamics_.n_slots()); ++s)
      moved[s] = true;
  clamped_.erase(
      std::remove_if(clamped_.begin(), clamped_.end(), [&](int slot) { return !moved[slot]; }),
      clamped_.end());

  std::vector<bool>& present = moved;
  for (const int slot : known) present[slot] = true;
  std::vector<dem::EndRange> ends;
  for (int s = 0; s < dynamics_.n_slots(); ++s) {
    if (!present[s]) continue;
    if (s == 0 || !present[s - 1]) ends.push_back({s, s});
    ++ends.back().end;
  }
  ribs_.set_present_ends(std::move(ends));
}

dem::Vector3 RibTransfer::clamp_force() const
{
  dem::Vector3 sum(0, 0, 0);
  for (const int slot : clamped_)
    for (int c = 0; c < 3; ++c)
      sum[c] += dem::on_grid<dem::clamp_grid>(dynamics_.slot_clamp_forces()[c][slot]);
  return sum;
}

void RibTransfer::refresh_ribs()
{
  const auto copy = [this](const fem::Lane& from, double* to) {
    for (const dem::EndRange& ends : ribs_.present_ends()) {
      const int end = std::min(ends.end, dynamics_.n_slots());
      std::copy(from.data() + ends.begin, from.data() + end, to + ends.begin);
    }
  };
  for (int c = 0; c < 3; ++c) {
    copy(dynamics_.slot_positions()[c], ribs_.position.row(c));
    copy(dynamics_.slot_velocities()[c], ribs_.velocity.row(c));
    copy(dynamics_.slot_spins()[c], ribs_.spin.row(c));
  }
  for (int c = 0; c < 4; ++c) // w x y z there, x y z w here
    copy(dynamics_.slot_orientations()[c], ribs_.rotation.row((c + 3) % 4));
}

void RibTransfer::apply(const std::vector<dem::RodLoads>& loads)
{
  dynamics_.clear_loads();
  for (const dem::RodLoads& load : loads)
    for (const int end : {0, 1})
      dynamics_.add_end_load(load.rib, end, load.force[end], load.moment[end]);
}

void RibTransfer::update_walls(double dt)
{
  if (walls_) walls_->update(ribs_, dt);
}

void RibTransfer::apply_walls(double h)
{
  if (walls_) walls_->load(ribs_, h, dynamics_);
}

void RibTransfer::add_wall_rates(std::vector<NodeRate>& rates) const
{
  if (walls_) walls_->add_rates(ribs_, rates);
}

std::vector<NodeRate> RibTransfer::contact_rates(const dem::RibContacts& contacts) const
{
  std::vector<NodeRate> rates;
  for (const dem::RibContact& c : contacts.contacts()) {
    if (c.overlap <= 0) continue;
    const int first = ribs_.shape(c.rib).first_end;
    const dem::Vector3 chord = ribs_.position[first + 1] - ribs_.position[first];
    const double length = chord.norm(), arm = c.arm.norm();
    const dem::Vector3 normal = c.force.norm() > 0 ? c.force.normalized() : dem::Vector3::UnitZ();
    const dem::Vector3 moment = c.arm.cross(normal); // of a unit force
    const double turning = moment.dot(chord) / length;
    const dem::Vector3 couple = moment.cross(chord) / (length * length);
    // What a unit force along the normal, and one across it in the worst direction, does to each
    // end: along the rod it turns the chord, across the rod the section.
    double pushed[2], dragged[2];
    for (int end : {0, 1}) {
      const int node = lattice().element(c.rib).node[end];
      const double share = end == 0 ? 1 - c.xi : c.xi, side = end == 0 ? -1 : 1;
      const double m = dynamics_.mass(node), j = dynamics_.inertia(node);
      pushed[end] = std::sqrt((share * normal + side * couple).squaredNorm() / m +
                              share * share * turning * turning / j);
      dragged[end] =
          std::max((share + arm / length) / std::sqrt(m), share * std::sqrt(1 / m + arm * arm / j));
    }
    const dem::TangentStiffness k =
        dem::tangent_stiffness(contacts.properties(), c.overlap, c.radius);
    // Blocks of k v v^T, bounded node by node as by Gershgorin.
    for (int end : {0, 1}) {
      const double rate = std::max(k.normal * pushed[end] * (pushed[0] + pushed[1]),
                                   k.tangential * dragged[end] * (dragged[0] + dragged[1]));
      rates.push_back(node_rate(lattice().element(c.rib).node[end], rate));
    }
  }
  return rates;
}

SubstepNeeds RibTransfer::substep_needs(const std::vector<NodeRate>& rates, bool with_bends)
{
  SubstepNeeds needs;
  for (const NodeRate& at : rates)
    needs.contacts = std::max(needs.contacts, node_rates_[at.node] += at.rate);
  for (const NodeRate& at : rates) node_rates_[at.node] = 0;
  needs.beams = dynamics_.extremes(with_bends);
  return needs;
}

int RibTransfer::required_substeps(double dt, const SubstepNeeds& needs, double damping_ratio) const
{
  if (rigid_) return 1;
  const double beam = 2 / dynamics_.stable_step(needs.beams), z = damping_ratio;
  const double stable = 2 / std::sqrt(beam * beam + needs.contacts) * (std::sqrt(1 + z * z) - z);
  return std::max(2, static_cast<int>(std::ceil(dt / (0.75 * stable))));
}
} // namespace interlock::coupling
