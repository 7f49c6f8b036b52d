#include "dem/lists/neighbour_lists.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <chrono>
#include <tuple>

namespace interlock::dem
{
namespace
{
namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using BoostBox = bg::model::box<BoostPoint>;

// Skins last about this many steps at the present speed, the inner ones at the present
// acceleration, too, and for fewer steps where that would mean too many lanes.
constexpr double most_inner_steps = 100, least_inner_steps = 25, middle_steps = 400,
                 outer_steps = 3000;
// In units of the mean bounding radius of the clumps.
constexpr double inner_least = 8e-5, inner_widest = 1e-2, middle_least = 0.005,
                 middle_widest = 0.08, outer_least = 0.16, outer_widest = 0.6;

BoostBox box_around(const Vector3& x, double r)
{
  return {BoostPoint(x[0] - r, x[1] - r, x[2] - r), BoostPoint(x[0] + r, x[1] + r, x[2] + r)};
}
} // namespace

void NeighbourLists::set(const ListSettings& settings)
{
  settings_ = settings;
  size_ = 0;
  invalidate();
}

void NeighbourLists::choose_sizes(const Clumps& clumps)
{
  double sum = 0;
  for (int i = 0; i < clumps.size(); ++i) sum += clumps.bounding_radius(i);
  const double mean = sum / clumps.size();
  if (size_ > 0 && std::abs(mean - size_) < 0.1 * size_) return;
  size_ = mean;
  inner_rest_ = settings_.inner_skin > 0 ? settings_.inner_skin : inner_least * mean;
  inner_most_ = std::max(inner_rest_, inner_widest * mean);
  middle_rest_ = settings_.middle_skin > 0 ? settings_.middle_skin : middle_least * mean;
  middle_rest_ = std::max(middle_rest_, 2 * inner_rest_);
  middle_most_ = std::max(middle_widest * mean, 2 * std::max(middle_rest_, inner_most_));
  outer_rest_ = std::max(outer_least * mean, 2 * middle_rest_);
  outer_most_ = std::max(outer_widest * mean, 2 * middle_most_);
}

bool NeighbourLists::update(const Clumps& clumps, const std::vector<Wall>& walls, double dt,
                            double gravity)
{
  if (clumps.size() == 0) {
    pairs_.reset(0);
    wall_lanes_.reset(0);
    wall_segments_.assign(walls.size(), {0, 0});
    valid_ = false;
    expiring_ = renewed_ = {};
    built_now_ = true;
    return true;
  }
  built_now_ = false;
  if (valid_ && inner_holds(clumps, walls) && !renewed_.inner) {
    expiring_.inner = inner_.is_nearly_used_up();
    return false;
  }

  walk_.take_shapes(clumps.shapes());
  choose_sizes(clumps);
  speed_.resize(clumps.size());
  acceleration_.resize(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) {
    const double reach = clumps.member_reach(i);
    speed_[i] = clumps.velocity[i].norm() + clumps.spin[i].norm() * reach;
    const Vector3 fall = clumps.force[i] * clumps.inverse_mass[i] - gravity * Vector3::UnitZ();
    const double turning = clumps.torque[i].norm() * clumps.inverse_inertia[i].maxCoeff();
    acceleration_[i] = fall.norm() + turning * reach;
  }
  choose_inner_skins(clumps, walls, dt);
  if (valid_) middle_.measure(clumps, middle_used_);
  ++inner_since_middle_;
  if (!valid_ || renewed_.middle || !middle_holds(walls)) {
    build_middle(clumps, walls, dt);
    inner_since_middle_ = 0;
  }
  inner_.resize(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) inner_.take(clumps, i, next_inner_skin_[i]);
  build_pair_lanes(clumps);
  build_wall_lanes(clumps, walls);
  ++counts_.inner_builds;
  counts_.lanes = pairs_.size();
  valid_ = true;
  adapt();
  built_now_ = true;
  renewed_ = {};
  expiring_ = {false, middle_is_nearly_used_up()};
  return true;
}

// Whether the inner list after this one will perhaps need more than the middle level has, if clumps
// go on as since that was built.
bool NeighbourLists::middle_is_nearly_used_up() const
{
  if (inner_since_middle_ == 0) return false;
  const double more = 1 + 1. / inner_since_middle_;
  for (int i = 0; i < next_inner_skin_.size(); ++i)
    if (next_inner_skin_[i] + more * middle_used_[i] > middle_.skin[i]) return true;
  return false;
}

bool NeighbourLists::inner_holds(const Clumps& clumps, const std::vector<Wall>& walls)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
    if ((walls[w].corner - at_walls_[w].inner_reference).norm() > at_walls_[w].inner_skin)
      return false;
  return inner_.holds(clumps);
}

void NeighbourLists::choose_inner_skins(const Clumps& clumps, const std::vector<Wall>& walls,
                                        double dt)
{
  next_inner_skin_.resize(clumps.size());
  // A stone that trembles has hardly any speed where it turns, but is soon away.
  const double time = inner_steps_ * dt;
  for (int i = 0; i < clumps.size(); ++i)
    next_inner_skin_[i] = std::clamp(time * speed_[i] + 0.5 * time * time * acceleration_[i],
                                     inner_rest_, inner_most_);
  if (at_walls_.size() != walls.size()) {
    at_walls_.resize(walls.size());
    valid_ = false;
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    at_walls_[w].inner_reference = walls[w].corner;
    const double speed = walls[w].velocity.norm();
    at_walls_[w].inner_skin = speed > 0 ? std::clamp(time * speed, inner_rest_, inner_most_) : 0;
  }
}

// Whether the middle level can be filtered into the inner one.
bool NeighbourLists::middle_holds(const std::vector<Wall>& walls) const
{
  for (int i = 0; i < next_inner_skin_.size(); ++i)
    if (next_inner_skin_[i] + middle_used_[i] > middle_.skin[i]) return false;
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (at_walls_[w].inner_skin + (walls[w].corner - at_walls_[w].reference).norm() >
        at_walls_[w].skin)
      return false;
  return true;
}

void NeighbourLists::build_middle(const Clumps& clumps, const std::vector<Wall>& walls, double dt)
{
  mark(clumps, walls, dt);
  // A ball's surface moves with its centre alone.
  bool outer_holds = valid_;
  for (int i = 0; i < clumps.size() && outer_holds; ++i)
    outer_holds =
        middle_.skin[i] + (clumps.position[i] - outer_.position[i]).norm() <= outer_.skin[i];
  if (!outer_holds) {
    const auto start = std::chrono::steady_clock::now();
    build_outer(clumps, dt);
    broad_phase_time_ +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  walk_clump_pairs(clumps);
  walk_walls(clumps, walls);
  ++counts_.middle_builds;
  counts_.candidates = candidates_.size();
}

// Chooses the clumps and walls that get a new reference: those that have used more than an eighth
// of their skin or soon need three quarters of it, and all of them when nothing can be kept.
void NeighbourLists::mark(const Clumps& clumps, const std::vector<Wall>& walls, double dt)
{
  const int n = clumps.size();
  const bool all = !valid_;
  marked_.assign(n, all);
  wall_marked_.assign(walls.size(), all);
  middle_.resize(n);
  middle_used_.resize(n);
  for (int i = 0; i < n; ++i) {
    if (!all)
      marked_[i] = middle_used_[i] > 0.125 * middle_.skin[i] ||
                   next_inner_skin_[i] + middle_used_[i] > 0.75 * middle_.skin[i];
    if (!marked_[i]) continue;
    const double skin = std::clamp(middle_steps * dt * speed_[i], middle_rest_, middle_most_);
    middle_.take(clumps, i, std::max(skin, 2 * next_inner_skin_[i]));
    middle_used_[i] = 0;
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    WallCandidates& at = at_walls_[w];
    const double used = (walls[w].corner - at.reference).norm();
    wall_marked_[w] = all || at.inner_skin + used > 0.75 * at.skin;
    if (!wall_marked_[w]) continue;
    at.reference = walls[w].corner;
    at.skin = std::min(middle_steps * dt * walls[w].velocity.norm(), middle_most_);
    at.skin = std::max(at.skin, 2 * at.inner_skin);
  }
}

void NeighbourLists::build_outer(const Clumps& clumps, double dt)
{
  const int n = clumps.size();
  outer_.resize(n);
  for (int i = 0; i < n; ++i) {
    const double skin = std::clamp(outer_steps * dt * speed_[i], outer_rest_, outer_most_);
    outer_.take(clumps, i, std::max(skin, 2 * middle_.skin[i]));
  }
  using Entry = std::pair<BoostBox, int>;
  std::vector<Entry> boxes;
  boxes.reserve(n);
  for (int i = 0; i < n; ++i)
    boxes.emplace_back(box_around(clumps.position[i], clumps.bounding_radius(i) + outer_.skin[i]),
                       i);
  const bg::index::rtree<Entry, bg::index::quadratic<16>> tree(boxes);

  // Candidates of pairs that stay are kept.
  const std::vector<ClumpPair> old = std::move(clump_pairs_);
  clump_pairs_.clear();
  auto kept = old.begin();
  std::vector<int> partners;
  std::vector<Entry> hits;
  for (int i = 0; i < n; ++i) {
    const double reach = clumps.bounding_radius(i) + outer_.skin[i];
    hits.clear();
    partners.clear();
    tree.query(bg::index::intersects(boxes[i].first), std::back_inserter(hits));
    for (const Entry& hit : hits) {
      const int j = hit.second;
      if (j <= i) continue;
      if (clumps.ghost[i] == 1 && clumps.ghost[j] == 1) continue; // another rank's
      const double limit = reach + clumps.bounding_radius(j) + outer_.skin[j];
      if ((clumps.position[j] - clumps.position[i]).squaredNorm() < limit * limit)
        partners.push_back(j);
    }
    std::sort(partners.begin(), partners.end());
    for (const int j : partners) {
      ClumpPair pair{i, j};
      while (kept != old.end() && std::tie(kept->i, kept->j) < std::tie(i, j)) ++kept;
      if (kept != old.end() && kept->i == i && kept->j == j)
        pair.first = kept->first, pair.last = kept->last;
      clump_pairs_.push_back(pair);
    }
  }
  ++counts_.outer_builds;
  counts_.clump_pairs = clump_pairs_.size();
}

void NeighbourLists::walk_clump_pairs(const Clumps& clumps)
{
  old_candidates_.swap(candidates_);
  candidates_.clear();
  for (ClumpPair& pair : clump_pairs_) {
    const int first = static_cast<int>(candidates_.size());
    if (!marked_[pair.i] && !marked_[pair.j]) {
      candidates_.insert(candidates_.end(), old_candidates_.begin() + pair.first,
                         old_candidates_.begin() + pair.last);
    } else {
      // A partner that keeps its reference may have been nearer there.
      const double used = middle_used_[pair.i] + middle_used_[pair.j];
      const double cut = middle_.skin[pair.i] + middle_.skin[pair.j] + used;
      const double limit = clumps.bounding_radius(pair.i) + clumps.bounding_radius(pair.j) + cut;
      if ((clumps.position[pair.j] - clumps.position[pair.i]).squaredNorm() < limit * limit)
        walk_.add_pairs(clumps, pair.i, pair.j, cut, candidates_);
      for (std::size_t c = first; c < candidates_.size(); ++c) candidates_[c].gap -= used;
    }
    pair.first = first;
    pair.last = static_cast<int>(candidates_.size());
  }
}

void NeighbourLists::walk_walls(const Clumps& clumps, const std::vector<Wall>& walls)
{
  for (std::size_t w = 0; w < walls.size(); ++w) {
    WallCandidates& at = at_walls_[w];
    std::swap(at.clumps, old_at_wall_.clumps);
    std::swap(at.near, old_at_wall_.near);
    at.clumps.clear();
    at.near.clear();
    const double wall_used = (walls[w].corner - at.reference).norm();
    auto old = old_at_wall_.clumps.begin();
    for (int i = 0; i < clumps.size(); ++i) {
      while (old != old_at_wall_.clumps.end() && old->i < i) ++old;
      if (clumps.ghost[i] == 1) continue; // another rank's
      const int first = static_cast<int>(at.near.size());
      if (!marked_[i] && !wall_marked_[w]) {
        if (old == old_at_wall_.clumps.end() || old->i != i) continue;
        at.near.insert(at.near.end(), old_at_wall_.near.begin() + old->first,
                       old_at_wall_.near.begin() + old->last);
      } else {
        const double used = middle_used_[i] + wall_used;
        const double cut = middle_.skin[i] + at.skin + used;
        const Vector3 x = clumps.position[i];
        if ((x - walls[w].nearest_point(x)).norm() > clumps.bounding_radius(i) + cut) continue;
        walk_.add_at_wall(clumps, i, walls[w], cut, at.near);
        for (std::size_t c = first; c < at.near.size(); ++c) at.near[c].gap -= used;
      }
      if (static_cast<int>(at.near.size()) > first)
        at.clumps.push_back({i, first, static_cast<int>(at.near.size())});
    }
  }
}

// Finer clumps have more spheres within the same skin: narrower skins then cost less.
void NeighbourLists::adapt()
{
  const double lanes = pairs_.size() + 100.;
  if (settings_.middle_skin == 0) {
    const double ratio = candidates_.size() / lanes, widest = middle_least * size_;
    if (ratio > 12 && middle_rest_ > 3 * inner_rest_) middle_rest_ *= 0.9;
    if (ratio < 5) middle_rest_ = std::min(1.1 * middle_rest_, widest);
  }
  if (settings_.inner_skin == 0) {
    const double touching = 100. + count_touching(pairs_);
    if (lanes > 1.5 * touching) {
      inner_rest_ = std::max(0.9 * inner_rest_, 0.1 * inner_least * size_);
      inner_steps_ = std::max(0.9 * inner_steps_, least_inner_steps);
    }
    if (lanes < 1.25 * touching) inner_rest_ = std::min(1.1 * inner_rest_, inner_least * size_);
    if (lanes < 1.4 * touching) inner_steps_ = std::min(1.1 * inner_steps_, most_inner_steps);
  }
}
} // namespace interlock::dem
