#include "dem/lanes/contact_lanes.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
// The first sphere has a radius of -1 km and overlaps nothing, wherever its bodies are.
LaneBlock idle_block()
{
  LaneBlock idle = {};
  for (int l = 0; l < lane_width; ++l) {
    idle.centre2[0][l] = 1;
    idle.radius1[l] = -1e3;
    idle.reduced_mass[l] = idle.root_mass[l] = idle.reduced_radius[l] = idle.gradient[l] = 1;
  }
  return idle;
}

Vector3 get(const LaneBlock::Row (&rows)[3], int l)
{
  return {rows[0][l], rows[1][l], rows[2][l]};
}

void set(LaneBlock::Row (&rows)[3], int l, const Vector3& a)
{
  for (int c = 0; c < 3; ++c) rows[c][l] = a[c];
}
} // namespace

void ContactLanes::reset(int n)
{
  static const LaneBlock idle = idle_block();
  keys_.assign(n, {});
  blocks_.assign(padded(n) / lane_width, idle);
}

void ContactLanes::set_pair(int k, const ContactKey& key, const Clumps& clumps)
{
  keys_[k] = key;
  const Sphere &sa = clumps.shape_of(key.i).spheres[key.a],
               &sb = clumps.shape_of(key.j).spheres[key.b];
  LaneBlock& block = this->block(k);
  const int l = k % lane_width;
  block.i[l] = key.i, block.j[l] = key.j;
  block.same_first[l] = k > 0 && keys_[k - 1].i == key.i ? -1 : 0;
  set(block.centre1, l, sa.centre);
  set(block.centre2, l, sb.centre);
  block.radius1[l] = sa.radius;
  block.radius2[l] = sb.radius;
  const double m1 = clumps.mass[key.i], m2 = clumps.mass[key.j];
  block.reduced_mass[l] = m1 * m2 / (m1 + m2);
  block.root_mass[l] = std::sqrt(block.reduced_mass[l]);
  block.reduced_radius[l] = sa.radius * sb.radius / (sa.radius + sb.radius);
}

void ContactLanes::set_wall(int k, const ContactKey& key, const Clumps& clumps)
{
  keys_[k] = key;
  const Sphere& sphere = clumps.shape_of(key.i).spheres[key.a];
  LaneBlock& block = this->block(k);
  const int l = k % lane_width;
  block.i[l] = key.i;
  set(block.centre1, l, sphere.centre);
  block.radius1[l] = block.reduced_radius[l] = sphere.radius;
  block.reduced_mass[l] = clumps.mass[key.i];
  block.root_mass[l] = std::sqrt(block.reduced_mass[l]);
}

void ContactLanes::finish_pairs()
{
  if (keys_.empty()) return;
  for (std::size_t k = keys_.size(); k < blocks_.size() * lane_width; ++k) {
    LaneBlock& block = this->block(static_cast<int>(k));
    block.i[k % lane_width] = keys_.back().i;
    block.j[k % lane_width] = keys_.back().j;
    block.same_first[k % lane_width] = -1;
  }
}

LaneMemory ContactLanes::memory(int k) const
{
  const LaneBlock& block = this->block(k);
  const int l = k % lane_width;
  LaneMemory memory;
  memory.spring = get(block.spring, l);
  memory.dashpot = get(block.dashpot, l);
  memory.force = get(block.force, l);
  memory.overlap = block.overlap[l];
  memory.crushed = block.crushed[l];
  memory.tangential_stiffness = block.tangential_stiffness[l];
  memory.shared_depth = block.shared_depth[l];
  memory.gradient = block.gradient[l];
  return memory;
}

void ContactLanes::remember(int k, const LaneMemory& memory)
{
  LaneBlock& block = this->block(k);
  const int l = k % lane_width;
  set(block.spring, l, memory.spring);
  set(block.dashpot, l, memory.dashpot);
  set(block.force, l, memory.force);
  block.overlap[l] = memory.overlap;
  block.crushed[l] = memory.crushed;
  block.tangential_stiffness[l] = memory.tangential_stiffness;
  block.shared_depth[l] = memory.shared_depth;
  block.gradient[l] = memory.gradient;
}

ContactShare ContactLanes::share(int k) const
{
  const LaneBlock& block = this->block(k);
  const int l = k % lane_width;
  if (block.overlap[l] <= 0 || block.shared_depth[l] <= 0) return {};
  return {block.shared_depth[l], block.gradient[l]};
}

double ContactLanes::stored_energy(int k, const ContactProperties& pair) const
{
  const LaneBlock& block = this->block(k);
  const int l = k % lane_width;
  const double elastic = block.overlap[l] - (pair.crushing_pressure > 0 ? block.crushed[l] : 0);
  if (elastic <= 0) return 0;
  return dem::stored_energy(pair, elastic, block.reduced_radius[l], get(block.spring, l).norm(),
                            share(k));
}

int count_touching(const ContactLanes& lanes)
{
  int touching = 0;
  for (const LaneBlock& block : lanes.blocks())
    for (const double overlap : block.overlap) touching += overlap > 0;
  return touching;
}

double largest_overlap(const ContactLanes& lanes)
{
  double largest[lane_width] = {};
  for (const LaneBlock& block : lanes.blocks())
    for (int l = 0; l < lane_width; ++l) largest[l] = larger(largest[l], block.overlap[l]);
  return *std::max_element(largest, largest + lane_width);
}
} // namespace interlock::dem
