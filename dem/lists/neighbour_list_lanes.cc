// The inner level of the neighbour lists: lanes about to touch, and the histories they carry over.
#include "dem/lists/neighbour_lists.h"

#include <algorithm>
#include <tuple>

namespace interlock::dem
{
namespace
{
auto key_of(const ContactLanes& lanes, int k)
{
  return std::make_tuple(lanes.i[k], lanes.j[k], lanes.a[k], lanes.b[k]);
}

// Histories of lanes [begin, end) from those of old lanes with the same key; both are sorted.
void carry_histories(const ContactLanes& old, WallSegment from, ContactLanes& lanes, WallSegment to)
{
  int o = from.begin;
  for (int k = to.begin; k < to.end; ++k) {
    const auto key = key_of(lanes, k);
    while (o < from.end && key_of(old, o) < key) ++o;
    if (o == from.end) return;
    if (key_of(old, o) == key) lanes.copy_history(k, old, o);
  }
}

bool comes_before(const ContactKey& x, const ContactKey& y)
{
  return std::tie(x.i, x.j, x.a, x.b) < std::tie(y.i, y.j, y.a, y.b);
}

// Puts those old lanes that touched and are not among the keys from `begin` on back into their
// place. A contact that opens is evaluated once more, to book what it lost; however wide it opened
// within the step, this must not depend on the skins.
void keep_touching(const ContactLanes& old, WallSegment from, std::ptrdiff_t begin,
                   std::vector<ContactKey>& keys)
{
  const std::ptrdiff_t end = keys.size();
  std::ptrdiff_t k = begin;
  for (int o = from.begin; o < from.end; ++o) {
    if (old.overlap[o] <= 0) continue;
    const ContactKey key{static_cast<int>(old.i[o]), static_cast<int>(old.j[o]), old.a[o],
                         old.b[o]};
    while (k < end && comes_before(keys[k], key)) ++k;
    if (k == end || comes_before(key, keys[k])) keys.push_back(key);
  }
  std::inplace_merge(keys.begin() + begin, keys.begin() + end, keys.end(), comes_before);
}
} // namespace

void NeighbourLists::build_pair_lanes(const Clumps& clumps)
{
  keys_.clear();
  for (const ClumpPair& pair : clump_pairs_) {
    if (pair.first == pair.last) continue;
    const int i = pair.i, j = pair.j;
    const double skins = next_inner_skin_[i] + next_inner_skin_[j];
    const double used = middle_used_[i] + middle_used_[j];
    // Measured only where the bound alone would let too much pass.
    const bool measure = used > 0.3 * skins;
    for (int c = pair.first; c < pair.last; ++c) {
      const NearSpheres& near = candidates_[c];
      if (near.gap > skins + used) continue;
      if (measure) {
        const Sphere &sa = clumps.shape_of(i).spheres[near.a],
                     &sb = clumps.shape_of(j).spheres[near.b];
        const Vector3 d = clumps.position[i] - clumps.position[j] +
                          (clumps.member_offset(i, near.a) - clumps.member_offset(j, near.b));
        const double reach = sa.radius + sb.radius + skins;
        if (d.squaredNorm() > reach * reach) continue;
      }
      keys_.push_back({i, j, near.a, near.b});
    }
  }
  keep_touching(pairs_, {0, pairs_.size()}, 0, keys_);
  std::swap(old_pairs_, pairs_);
  const int n = static_cast<int>(keys_.size());
  pairs_.resize(0);
  pairs_.resize(n);
  for (int k = 0; k < n; ++k) pairs_.set_pair(k, keys_[k], clumps);
  carry_histories(old_pairs_, {0, old_pairs_.size()}, pairs_, {0, n});
}

void NeighbourLists::build_wall_lanes(const Clumps& clumps, const std::vector<Wall>& walls)
{
  keys_.clear();
  old_wall_segments_.swap(wall_segments_);
  wall_segments_.clear();
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallCandidates& at = at_walls_[w];
    keys_.resize(padded(static_cast<int>(keys_.size())));
    WallSegment segment{static_cast<int>(keys_.size()), 0};
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
    if (w < old_wall_segments_.size())
      keep_touching(wall_lanes_, old_wall_segments_[w], segment.begin, keys_);
    segment.end = static_cast<int>(keys_.size());
    wall_segments_.push_back(segment);
  }
  std::swap(old_wall_lanes_, wall_lanes_);
  wall_lanes_.resize(0);
  wall_lanes_.resize(static_cast<int>(keys_.size()));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallSegment segment = wall_segments_[w];
    for (int k = segment.begin; k < segment.end; ++k) wall_lanes_.set_wall(k, keys_[k], clumps);
    if (w < old_wall_segments_.size())
      carry_histories(old_wall_lanes_, old_wall_segments_[w], wall_lanes_, segment);
  }
}

void NeighbourLists::renumber_clumps(const std::vector<int>& new_index)
{
  // Order is kept by the renumbering, so the lists stay sorted.
  int kept = 0;
  ContactLanes& p = pairs_;
  for (int k = 0; k < p.size(); ++k) {
    const int i = new_index[p.i[k]], j = new_index[p.j[k]];
    if (i < 0 || j < 0) continue;
    p.i[kept] = i, p.j[kept] = j, p.a[kept] = p.a[k], p.b[kept] = p.b[k];
    p.copy_history(kept, p, k);
    ++kept;
  }
  p.resize(kept);
  ContactLanes& w = wall_lanes_;
  int next = 0;
  for (WallSegment& segment : wall_segments_) {
    const int begin = padded(next);
    for (; next < begin; ++next) w.overlap[next] = 0; // padding holds nothing
    for (int k = segment.begin; k < segment.end; ++k) {
      const int i = new_index[w.i[k]];
      if (i < 0) continue;
      w.i[next] = i, w.j[next] = w.j[k], w.a[next] = w.a[k], w.b[next] = 0;
      w.copy_history(next, w, k);
      ++next;
    }
    segment = {begin, next};
  }
  w.resize(next);
  invalidate();
}

void NeighbourLists::renumber_walls(const std::vector<int>& new_index)
{
  ContactLanes& w = wall_lanes_;
  std::vector<WallSegment> kept;
  int next = 0;
  for (std::size_t old = 0; old < wall_segments_.size(); ++old) {
    if (new_index[old] < 0) continue;
    const WallSegment segment = wall_segments_[old];
    const int begin = padded(next);
    for (; next < begin; ++next) w.overlap[next] = 0; // padding holds nothing
    for (int k = segment.begin; k < segment.end; ++k, ++next) {
      w.i[next] = w.i[k], w.j[next] = new_index[old], w.a[next] = w.a[k], w.b[next] = 0;
      w.copy_history(next, w, k);
    }
    kept.push_back({begin, next});
  }
  w.resize(next);
  wall_segments_ = kept;
  invalidate();
}

void NeighbourLists::restore(const Clumps& clumps, int n_walls,
                             const std::vector<Remembered>& pairs,
                             const std::vector<Remembered>& at_walls)
{
  pairs_.resize(0);
  pairs_.resize(static_cast<int>(pairs.size()));
  for (int k = 0; k < pairs_.size(); ++k) {
    pairs_.set_pair(k, pairs[k].key, clumps);
    pairs_.remember(k, pairs[k].memory);
  }
  wall_segments_.assign(n_walls, {});
  wall_lanes_.resize(0);
  auto contact = at_walls.begin();
  int next = 0;
  for (int w = 0; w < n_walls; ++w) {
    next = padded(next);
    wall_segments_[w].begin = next;
    for (; contact != at_walls.end() && contact->key.j == w; ++contact, ++next) {
      wall_lanes_.resize(next + 1);
      wall_lanes_.set_wall(next, contact->key, clumps);
      wall_lanes_.remember(next, contact->memory);
    }
    wall_segments_[w].end = next;
  }
  invalidate();
}
} // namespace interlock::dem
