// Whether the spheres of a clump hang together.
#pragma once

#include "dem/bodies/clump_shape.h"

namespace interlock::dem
{
// Whether two spheres overlap or touch, |c_a - c_b| <= r_a + r_b, to within 1e-9 of the radii: a
// sphere that grew until it touched another one must not depend on rounding.
bool spheres_touch(const Sphere& a, const Sphere& b);

// The number of groups of spheres that touch each other: 1 for a clump in one piece, 0 for no
// sphere. A clump of several groups is still one rigid body, but with gaps through which a rib or a
// corner of another stone can pass.
int sphere_groups(const std::vector<Sphere>& spheres);
} // namespace interlock::dem
