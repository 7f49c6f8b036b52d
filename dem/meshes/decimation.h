// Coarser copies of closed surfaces, to look at; nothing is computed with them.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// At most about `triangles` of them, by collapsing edges in the order of what that costs in squared
// distance from the planes of the facets (Garland and Heckbert, SIGGRAPH 1997, by meshoptimizer),
// so that corners and edges of angular stones stay. Nodes are some of the old ones; a closed
// surface stays closed. Stops earlier where a step would take it farther than a twentieth of its
// size from the old surface. A mesh that is coarser already comes back as it is.
TriangleMesh decimated(const TriangleMesh& mesh, int triangles);
} // namespace interlock::dem
