// Synthetic angular ballast: closed, outward meshes that stand in for scans when there are none.
#pragma once

#include "dem/triangle_mesh.h"

#include <cstdint>

namespace interlock::dem
{
// One batch of `count` stones, deterministic from `seed`. Sieve sizes (stone_size.h) follow Table 5
// of Ferellec and McDowell (2010), read as shares of mass, with 0-22 mm taken as 18-22 mm. Each
// stone's longest axis is near x, its shortest near z, and its centre of volume is the origin.
// Lengths in m. 1442 to 2892 nodes, 1 to 2 mm apart. Throws InputError when count < 1.
std::vector<TriangleMesh> make_stones(int count, std::uint64_t seed);

// Sieve sizes of a batch in ascending order [m]: the (i + 1/2)/count quantiles of the number
// distribution that has the mass shares of Table 5, so that even a dozen stones follow it.
std::vector<double> ballast_sizes(int count);
} // namespace interlock::dem
