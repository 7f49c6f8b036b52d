// A part of a lattice: which slots the explicit integrator moves here, and what that needs.
#include "fem/explicit/explicit_dynamics.h"
#include "fem/explicit/wide.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace interlock::fem
{
int ExplicitDynamics::slots_of_block()
{
  return wide_lanes;
}

void ExplicitDynamics::move_all_blocks()
{
  std::vector<int> blocks(n_blocks());
  std::iota(blocks.begin(), blocks.end(), 0);
  move_blocks(blocks);
}

// A slot moves by the elements at both of its sides, and at a junction by those of all its slots:
// the ends of all of them must be known here.
void ExplicitDynamics::move_blocks(const std::vector<int>& blocks)
{
  moved_.clear();
  for (const int block : blocks) moved_.push_back(block * wide_lanes);
  const auto is_moved = [&](int slot) {
    return std::binary_search(moved_.begin(), moved_.end(), block_of(slot) * wide_lanes);
  };
  const auto joined = [this](int s) { return beams_.inverse_length[s] != 0; }; // to the next slot

  std::set<int> border, slots; // first slots of blocks; ends of elements
  const auto need_elements_at = [&](int s) {
    border.insert(block_of(s) * wide_lanes); // where the forces at the slot are summed
    for (const int first : {s - 1, s})
      if (first >= 0 && joined(first)) {
        border.insert(block_of(first) * wide_lanes);
        slots.insert({first, first + 1});
      }
  };
  for (const int first : moved_)
    for (const int s : {first, std::min(first + wide_lanes, n_slots_) - 1}) need_elements_at(s);
  junctions_.clear();
  for (std::size_t j = 0; j < junction_slots_.size(); ++j) {
    const std::vector<int>& at = junction_slots_[j];
    if (std::none_of(at.begin(), at.end(), is_moved)) continue;
    junctions_.push_back(static_cast<int>(j));
    std::for_each(at.begin(), at.end(), need_elements_at);
  }

  const auto take = [&](const std::set<int>& from, std::vector<int>& to) {
    to.clear();
    std::copy_if(from.begin(), from.end(), std::back_inserter(to),
                 [&](int s) { return !is_moved(s); });
  };
  take(border, border_);
  take(slots, border_slots_);
}

std::vector<double*> ExplicitDynamics::motion_rows()
{
  std::vector<double*> rows;
  for (Lanes3* lanes : {&position_, &velocity_, &spin_})
    for (Lane& lane : *lanes) rows.push_back(lane.data());
  for (Lane& lane : orientation_) rows.push_back(lane.data());
  return rows;
}

std::vector<double*> ExplicitDynamics::all_rows()
{
  std::vector<double*> rows = motion_rows();
  if (!options_.spherical_inertia)
    for (Lane& lane : angular_momentum_) rows.push_back(lane.data());
  for (Lane& lane : clamp_force_) rows.push_back(lane.data());
  for (Lane* lane : {&clamp_work_, &load_work_, &damping_loss_}) rows.push_back(lane->data());
  if (softens_) rows.push_back(beams_.plastic_stretch.data());
  return rows;
}
} // namespace interlock::fem
