// Facets of one surface that cut through each other.
#pragma once

#include "dem/triangle_mesh.h"

namespace interlock::dem
{
struct SelfIntersection {
  int pairs = 0;                   // of facets
  bool complete = true;            // false: the search stopped early, see below
  Vector3 point = Vector3::Zero(); // on the first pair found [m]
};

// Counts pairs of facets that cross along a piece of a line. Facets that share an edge never do,
// facets that share one vertex do only when they cut through each other away from it; touching and
// lying upon each other in one plane do not count, and neither does what is shallower than the
// rounding of single precision, in which most scans are written: 2.4e-7 of the largest coordinate.
// Method: Moeller, J. Graphics Tools 2(2) (1997): on the line where the two planes meet each facet
// has an interval, and they cross where the intervals overlap.
// Stops at 10,000 pairs, which are enough to know, or where so many facets lie in each other's
// boxes that comparing them would take minutes.
SelfIntersection find_self_intersection(const TriangleMesh& mesh);
} // namespace interlock::dem
