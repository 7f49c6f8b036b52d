// Form of a stone and evenness of its mesh in one go, for tables of stones.
#pragma once

#include "dem/stones/stone_size.h"

namespace interlock::dem
{
struct StoneForm {
  StoneSize size;        // with flatness, elongation and Wadell's sphericity
  double volume = 0;     // [m3]
  double convexity = 0;  // volume over that of the convex hull: 1 for a convex body
  double angularity = 0; // see angularity.h [degrees]
};
// Throws InputError when the surface has no volume.
StoneForm stone_form(const TriangleMesh& mesh);

// Lengths of the edges, each counted once for every facet.
struct NodeSpacing {
  double mean = 0;      // [m]
  double variation = 0; // standard deviation over mean
};
NodeSpacing node_spacing(const TriangleMesh& mesh);
} // namespace interlock::dem
