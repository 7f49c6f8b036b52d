#include "coupling/loop/rib_walls.h"

#include "coupling/loop/rib_wall_search.h"
#include "dem/contacts/single_contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

std::tuple<int, BoxSide> key(const RibTouch& touch)
{
  return {touch.vertex, touch.side};
}

bool holds_something(const RibTouch& touch)
{
  const dem::ContactHistory& h = touch.history;
  return h.overlap > 0 || !h.spring.isZero(0) || !h.dashpot.isZero(0);
}

// One end, or the linear share of both.
Vector3 at(const dem::VectorField& field, int vertex, double xi)
{
  const Vector3 here = field[vertex];
  return xi == 0 ? here : Vector3((1 - xi) * here + xi * Vector3(field[vertex + 1]));
}
} // namespace

RibWalls::RibWalls(const RibBox& box, const dem::RibSet& ribs,
                   const fem::ExplicitDynamics& dynamics)
    : box_(box), points_(box, ribs), node_(dynamics.n_slots())
{
  const std::vector<std::vector<int>> slots = dynamics.slots_of_nodes();
  for (std::size_t node = 0; node < slots.size(); ++node)
    for (const int slot : slots[node]) node_[slot] = static_cast<int>(node);
  for (const int node : node_) mass_.push_back(dynamics.mass(node));
  const int padded = dynamics.n_blocks() * fem::ExplicitDynamics::slots_of_block();
  friction_.resize(padded);
  damping_.resize(padded);
}

void RibWalls::update(const dem::RibSet& ribs, double dt)
{
  const RibWallSearch search(box_, ribs, dt);
  std::vector<RibTouch> near;
  near.reserve(touches_.size() + 8);
  auto old = touches_.cbegin();
  const auto look_at = [&](int vertex, BoxSide side) {
    if (!points_.can_touch(vertex, side)) return;
    RibTouch touch;
    touch.vertex = vertex, touch.side = side;
    while (old != touches_.cend() && key(*old) < key(touch)) ++old;
    if (old != touches_.cend() && key(*old) == key(touch)) touch = *old;
    const double room = search.room(vertex, points_.is_edge(side));
    if (points_.gap(ribs, vertex, side).overlap > -room || holds_something(touch))
      near.push_back(touch);
  };
  bool is_near[RibWallSearch::block];
  for (const dem::EndRange& ends : ribs.present_ends()) {
    const int end = std::min(ends.end, static_cast<int>(node_.size()));
    for (int first = ends.begin; first < end; first += RibWallSearch::block) {
      const int n = std::min(RibWallSearch::block, end - first);
      search.find(first, n, is_near);
      for (int k = 0; k < n; ++k) {
        if (!is_near[k]) continue;
        for (int side = 0; side < n_box_sides; ++side) {
          const bool is_there = !points_.is_edge(static_cast<BoxSide>(side)) || first + k + 1 < end;
          if (is_there) look_at(first + k, static_cast<BoxSide>(side));
        }
      }
    }
  }
  touches_ = std::move(near);
}

double RibWalls::mass_at(int vertex, double xi) const
{
  if (xi == 0) return mass_[vertex];
  return 1 / ((1 - xi) * (1 - xi) / mass_[vertex] + xi * xi / mass_[vertex + 1]);
}

void RibWalls::load(const dem::RibSet& ribs, double h, fem::ExplicitDynamics& dynamics)
{
  for (RibTouch& touch : touches_) {
    const WallGap gap = points_.gap(ribs, touch.vertex, touch.side);
    if (gap.overlap <= 0 && !holds_something(touch)) continue;
    evaluate(touch, gap, ribs, h);
    const Vector3 no_moment = Vector3::Zero();
    if (points_.is_edge(touch.side))
      dynamics.add_load(points_.rib_from(touch.vertex), gap.xi, touch.force, no_moment);
    else
      dynamics.add_slot_load(touch.vertex, touch.force, no_moment);
  }
}

void RibWalls::evaluate(RibTouch& touch, const WallGap& gap, const dem::RibSet& ribs, double h)
{
  const dem::ContactProperties& pair = box_.contact;
  const Vector3 velocity = at(ribs.velocity, touch.vertex, gap.xi);
  dem::ContactHistory& history = touch.history;
  dem::ContactEnergy energy;
  if (gap.overlap > 0) {
    dem::rotate_spring(history.spring, gap.n, Vector3::Zero());
    touch.force = dem::linear_contact_force(pair, mass_at(touch.vertex, gap.xi), gap.overlap, gap.n,
                                            velocity, h, history, energy);
  } else {
    dem::end_contact(pair, -gap.overlap, velocity, h, history, energy);
    touch.force.setZero();
  }
  friction_[touch.vertex] += energy.friction;
  damping_[touch.vertex] += energy.damping;
}

// At an element as for stones, blocks of k v v^T (RibTransfer::contact_rates); here v knows no
// direction.
void RibWalls::add_rates(const dem::RibSet& ribs, std::vector<NodeRate>& rates) const
{
  const double k = std::max(box_.contact.normal_stiffness, box_.contact.tangential_stiffness);
  for (const RibTouch& touch : touches_) {
    if (touch.history.overlap <= 0) continue;
    const double xi = points_.gap(ribs, touch.vertex, touch.side).xi;
    const int ends = points_.is_edge(touch.side) ? 2 : 1;
    double pushed[2] = {0, 0};
    for (int end = 0; end < ends; ++end)
      pushed[end] = (end == 0 ? 1 - xi : xi) / std::sqrt(mass_[touch.vertex + end]);
    for (int end = 0; end < ends; ++end)
      rates.push_back(
          node_rate(node_[touch.vertex + end], k * pushed[end] * (pushed[0] + pushed[1])));
  }
}

dem::ContactEnergy RibWalls::energy() const
{
  dem::ContactEnergy energy;
  for (const RibTouch& touch : touches_)
    energy.elastic +=
        dem::stored_energy(box_.contact, touch.history.overlap, 0, touch.history.spring.norm(), {});
  energy.friction = std::accumulate(friction_.begin(), friction_.end(), 0.);
  energy.damping = std::accumulate(damping_.begin(), damping_.end(), 0.);
  return energy;
}

Vector3 RibWalls::force() const
{
  Vector3 sum = Vector3::Zero();
  for (const RibTouch& touch : touches_) sum += touch.force;
  return sum;
}

double RibWalls::largest_overlap(const dem::RibSet& ribs) const
{
  double largest = 0;
  for (std::size_t v = 0; v < node_.size(); ++v)
    for (int side = 0; side < n_box_sides; ++side)
      if (points_.can_touch(static_cast<int>(v), static_cast<BoxSide>(side)))
        largest = std::max(
            largest, points_.gap(ribs, static_cast<int>(v), static_cast<BoxSide>(side)).overlap);
  return largest;
}

RibWallState RibWalls::state() const
{
  const auto of_slots = [this](const std::vector<double>& losses) {
    return std::vector<double>(losses.begin(), losses.begin() + node_.size());
  };
  RibWallState state{{}, of_slots(friction_), of_slots(damping_)};
  std::copy_if(touches_.begin(), touches_.end(), std::back_inserter(state.touches),
               holds_something);
  return state;
}

void RibWalls::set_state(const RibWallState& state)
{
  touches_ = state.touches;
  for (auto [from, to] : {std::pair(&state.friction, &friction_), {&state.damping, &damping_}}) {
    std::fill(to->begin(), to->end(), 0.);
    std::copy_n(from->begin(), std::min(from->size(), node_.size()), to->begin());
  }
}
} // namespace interlock::coupling
