// Synthetic angular ballast: closed, outward meshes that stand in for scans when there are none.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/stones/stone_style.h"

#include <cstdint>

namespace interlock::dem
{
// One batch of `count` stones, deterministic from `seed`, with the sieve sizes of ballast_sizes.h
// in random order. Each stone's longest axis is near x, its shortest near z, and its centre of
// volume is the origin, from which every ray meets the surface once. Nodes are spread nearly
// evenly. Lengths in m. Throws InputError when count < 1 or an entry of the style is out of range.
std::vector<TriangleMesh> make_stones(int count, std::uint64_t seed, const StoneStyle& style = {});
} // namespace interlock::dem
