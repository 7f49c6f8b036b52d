// Synthetic angular ballast: closed, outward meshes that stand in for scans when there are none.
#pragma once

#include "dem/triangle_mesh.h"

#include <cstdint>

namespace interlock::dem
{
// One batch of `count` stones, deterministic from `seed`. Sieve sizes follow Table 5 of Ferellec and
// McDowell (2010), read as shares of mass; each stone's longest axis is near x, its shortest near z, and
// its centre of volume is the origin. Lengths in m.
std::vector<TriangleMesh> make_stones(int count, std::uint64_t seed);
} // namespace interlock::dem
