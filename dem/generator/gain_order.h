// The spheres of a clump, the one that adds most to the shape first.
#pragma once

#include "dem/generator/clump_generator.h"
#include "dem/generator/clump_surface.h"

namespace interlock::dem
{
// Largest number of nodes that are candidates for a sphere and points at which the gain is
// measured. Of more nodes so many are drawn with the seed; with fewer it has no effect.
constexpr int most_candidates = 6000;

// Each sphere is the ball, of those at the candidates that touch the clump so far, with the largest
// gain (surface_gain.h); of equal ones that of the first node. So the spheres are one group. A node
// within d_min of the clump gets none. nodes_used counts kept spheres, and so does p_max. Frame of
// the surface. Counts nodes into `report` and says there why it stopped. Source of the heap of
// outdated gains: Minoux, Accelerated greedy algorithms for maximizing submodular set functions,
// Optimization Techniques, LNCIS 7 (1978), 234-243.
std::vector<Sphere> spheres_in_gain_order(const ClumpSurface& surface,
                                          const ClumpParameters& parameters, ClumpReport& report);
} // namespace interlock::dem
