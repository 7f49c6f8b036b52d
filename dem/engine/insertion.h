// Putting a clump among others so that nothing overlaps, proved sphere by sphere.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/walls/wall.h"

namespace interlock::dem
{
// True when a clump of `shape` with its centre of mass at `position` (world [m]) and turned by
// `orientation` (body to world) would overlap no clump and no wall, and keep at least `clearance`
// [m] from the surface of every member sphere. Bounding balls sort out what is far; what is left is
// decided by the member spheres, so two stones may lie in each other's ball. Spheres that touch in
// a point (or are exactly `clearance` apart) are free.
bool place_is_free(const Clumps& clumps, const std::vector<Wall>& walls, const ClumpShape& shape,
                   const Vector3& position, const Quaternion& orientation, double clearance = 0);
} // namespace interlock::dem
