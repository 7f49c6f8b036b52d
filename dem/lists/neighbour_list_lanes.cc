// The inner level of the neighbour lists: lanes about to touch, and the histories they carry over.
#include "dem/lists/neighbour_lists.h"

#include <cstdint>
#include <utility>

namespace interlock::dem
{
namespace
{
// (i, j) and (a, b) as one number each, which order as the keys do.
using Order = std::pair<std::uint64_t, std::uint64_t>;
Order order_of(const ContactKey& key)
{
  const auto joined = [](int high, int low) {
    return std::uint64_t(std::uint32_t(high)) << 32 | std::uint32_t(low);
  };
  return {joined(key.i, key.j), joined(key.a, key.b)};
}
} // namespace

// Appends `keys_` to the lanes to be made, each with the old lane of the same key if that one
// touched, and those old lanes that touched and are not among the keys. A contact that opens is
// evaluated once more, to book what it lost; however wide it opened within the step, this must not
// depend on the skins. Lanes that did not touch hold nothing.
void NeighbourLists::append_keys(const ContactLanes& old, WallSegment from)
{
  auto key = keys_.begin();
  for (int o = from.begin; o < from.end; ++o) {
    if (!old.holds_something(o)) continue;
    const Order touching = order_of(old.key(o));
    for (; key != keys_.end() && order_of(*key) < touching; ++key) new_lanes_.push_back({*key, -1});
    if (key != keys_.end() && order_of(*key) == touching) ++key;
    new_lanes_.push_back({old.key(o), o});
  }
  for (; key != keys_.end(); ++key) new_lanes_.push_back({*key, -1});
}

void NeighbourLists::build_pair_lanes(const Clumps& clumps)
{
  keys_.clear();
  int turned = -1; // the clump that `turn_i` belongs to
  Matrix3 turn_i = Matrix3::Identity();
  for (const ClumpPair& pair : clump_pairs_) {
    if (pair.first == pair.last) continue;
    const int i = pair.i, j = pair.j;
    const double skins = next_inner_skin_[i] + next_inner_skin_[j];
    const double used = middle_used_[i] + middle_used_[j];
    // Measured only where the bound alone would let too much pass.
    const bool measure = used > 0.3 * skins;
    Matrix3 turn_j;
    if (measure) {
      if (turned != i) turn_i = clumps.orientation[i].toRotationMatrix();
      turned = i;
      turn_j = clumps.orientation[j].toRotationMatrix();
    }
    const std::vector<Sphere>&of_i = clumps.shape_of(i).spheres, &of_j = clumps.shape_of(j).spheres;
    const Vector3 between = clumps.position[i] - clumps.position[j];
    for (int c = pair.first; c < pair.last; ++c) {
      const NearSpheres& near = candidates_[c];
      if (near.gap > skins + used) continue;
      if (measure) {
        const Sphere &sa = of_i[near.a], &sb = of_j[near.b];
        const Vector3 d = between + turn_i * sa.centre - turn_j * sb.centre;
        const double reach = sa.radius + sb.radius + skins;
        if (d.squaredNorm() > reach * reach) continue;
      }
      keys_.push_back({i, j, near.a, near.b});
    }
  }
  new_lanes_.clear();
  append_keys(pairs_, {0, pairs_.size()});
  std::swap(old_pairs_, pairs_);
  pairs_.reset(static_cast<int>(new_lanes_.size()));
  for (int k = 0; k < pairs_.size(); ++k) {
    const auto& [key, old] = new_lanes_[k];
    pairs_.set_pair(k, key, clumps);
    if (old >= 0) pairs_.remember(k, old_pairs_.memory(old));
  }
  pairs_.finish_pairs();
}

void NeighbourLists::build_wall_lanes(const Clumps& clumps, const std::vector<Wall>& walls)
{
  new_lanes_.clear();
  old_wall_segments_.swap(wall_segments_);
  wall_segments_.clear();
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallCandidates& at = at_walls_[w];
    keys_.clear();
    const double wall_used = (walls[w].corner - at.reference).norm();
    for (const WallClump& clump : at.clumps) {
      const int i = clump.i;
      const double skins = next_inner_skin_[i] + at.inner_skin;
      const double used = middle_used_[i] + wall_used;
      for (int c = clump.first; c < clump.last; ++c) {
        const NearSpheres& near = at.near[c];
        if (near.gap > skins + used) continue;
        const Vector3 x = clumps.position[i] + clumps.member_offset(i, near.a);
        const double reach = clumps.shape_of(i).spheres[near.a].radius + skins;
        if ((x - walls[w].nearest_point(x)).squaredNorm() > reach * reach) continue;
        keys_.push_back({i, static_cast<int>(w), near.a, 0});
      }
    }
    new_lanes_.resize(padded(static_cast<int>(new_lanes_.size())));
    const int begin = static_cast<int>(new_lanes_.size());
    const bool known = w < old_wall_segments_.size();
    append_keys(wall_lanes_, known ? old_wall_segments_[w] : WallSegment{0, 0});
    wall_segments_.push_back({begin, static_cast<int>(new_lanes_.size())});
  }
  std::swap(old_wall_lanes_, wall_lanes_);
  wall_lanes_.reset(static_cast<int>(new_lanes_.size()));
  for (const WallSegment& segment : wall_segments_)
    for (int k = segment.begin; k < segment.end; ++k) {
      const auto& [key, old] = new_lanes_[k];
      wall_lanes_.set_wall(k, key, clumps);
      if (old >= 0) wall_lanes_.remember(k, old_wall_lanes_.memory(old));
    }
}

// Order is kept by the renumbering, so what is remembered stays sorted.
void NeighbourLists::renumber_clumps(const Clumps& clumps, const std::vector<int>& new_index)
{
  std::vector<Remembered> pairs, at_walls;
  for (int k = 0; k < pairs_.size(); ++k) {
    const ContactKey& old = pairs_.key(k);
    const int i = new_index[old.i], j = new_index[old.j];
    if (pairs_.holds_something(k) && i >= 0 && j >= 0)
      pairs.push_back({{i, j, old.a, old.b}, pairs_.memory(k)});
  }
  for (const WallSegment& segment : wall_segments_)
    for (int k = segment.begin; k < segment.end; ++k) {
      const ContactKey& old = wall_lanes_.key(k);
      if (wall_lanes_.holds_something(k) && new_index[old.i] >= 0)
        at_walls.push_back({{new_index[old.i], old.j, old.a, 0}, wall_lanes_.memory(k)});
    }
  restore(clumps, static_cast<int>(wall_segments_.size()), pairs, at_walls);
}

void NeighbourLists::renumber_walls(const Clumps& clumps, const std::vector<int>& new_index)
{
  std::vector<Remembered> pairs, at_walls;
  for (int k = 0; k < pairs_.size(); ++k)
    if (pairs_.holds_something(k)) pairs.push_back({pairs_.key(k), pairs_.memory(k)});
  int n_walls = 0;
  for (std::size_t old = 0; old < wall_segments_.size(); ++old) {
    if (new_index[old] < 0) continue;
    ++n_walls;
    for (int k = wall_segments_[old].begin; k < wall_segments_[old].end; ++k)
      if (wall_lanes_.holds_something(k))
        at_walls.push_back({{wall_lanes_.key(k).i, new_index[old], wall_lanes_.key(k).a, 0},
                            wall_lanes_.memory(k)});
  }
  restore(clumps, n_walls, pairs, at_walls);
}

void NeighbourLists::restore(const Clumps& clumps, int n_walls,
                             const std::vector<Remembered>& pairs,
                             const std::vector<Remembered>& at_walls)
{
  pairs_.reset(static_cast<int>(pairs.size()));
  for (int k = 0; k < pairs_.size(); ++k) {
    pairs_.set_pair(k, pairs[k].key, clumps);
    pairs_.remember(k, pairs[k].memory);
  }
  wall_segments_.assign(n_walls, {});
  int n = 0;
  auto contact = at_walls.begin();
  for (int w = 0; w < n_walls; ++w) {
    const int begin = padded(n);
    for (n = begin; contact != at_walls.end() && contact->key.j == w; ++contact) ++n;
    wall_segments_[w] = {begin, n};
  }
  wall_lanes_.reset(n);
  contact = at_walls.begin();
  for (const WallSegment& segment : wall_segments_)
    for (int k = segment.begin; k < segment.end; ++k, ++contact) {
      wall_lanes_.set_wall(k, contact->key, clumps);
      wall_lanes_.remember(k, contact->memory);
    }
  invalidate();
}
} // namespace interlock::dem
