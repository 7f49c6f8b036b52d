// The spheres of a clump, nodes in the random order of the paper.
#pragma once

#include "dem/generator/clump_generator.h"
#include "dem/generator/clump_surface.h"

namespace interlock::dem
{
// Frame of the surface. Counts nodes into `report` and says there why it stopped.
std::vector<Sphere> spheres_in_random_order(const ClumpSurface& surface,
                                            const ClumpParameters& parameters, ClumpReport& report);
} // namespace interlock::dem
