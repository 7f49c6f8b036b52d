// Facets of one surface that cut through each other.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
struct SelfIntersection {
  int pairs = 0;                   // of facets
  bool complete = true;            // false: the search stopped early, see below
  Vector3 point = Vector3::Zero(); // on the first pair found [m]
};

// Counts pairs of facets that cross along a piece of a line (facet_crossing.h). Neighbours at an
// edge never do, neighbours at a vertex only when they cut through each other away from it;
// touching and lying upon each other in one plane do not count, nor does what is shallower than the
// rounding of single precision, in which most scans are written. Stops at 10,000 pairs, which are
// enough to know, or where so many facets lie in each other's boxes that comparing them would take
// minutes.
SelfIntersection find_self_intersection(const TriangleMesh& mesh);
} // namespace interlock::dem
