// The same stone with more spheres: small ones inside its surface, to see what the number of
// spheres costs.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/random_stream.h"

namespace interlock::dem
{
struct RadiusRange {
  double smallest = 0, largest = 0; // [m]
};

// Adds spheres until there are `n_spheres`. Each touches the surface of the union of the given
// spheres from inside: at a random point of a random one of them that no other one covers, with its
// centre on that sphere's radius, and its own radius uniform in `range`. So the union, volume and
// moments of inertia stay the same. Throws InputError, one full sentence, when the shape has more
// spheres already or no place for one of these radii.
ClumpShape refined_shape(const ClumpShape& shape, int n_spheres, const RadiusRange& range,
                         RandomStream& random);
} // namespace interlock::dem
