// Coarser copies of closed surfaces, to look at; nothing is computed with them.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// With so many triangles, by collapsing edges in the order of what that costs in squared distance
// from the planes of the facets (Garland and Heckbert, SIGGRAPH 1997, by meshoptimizer), so that
// corners and edges of angular stones stay. Nodes are some of the old ones. Stops earlier where a
// step would take it farther than a twentieth of its size from the old surface, and where the
// surface would not be closed: then it has a tenth more, or as many more as it takes. A mesh that
// is coarser already, or not closed itself, comes back as it is.
TriangleMesh decimated(const TriangleMesh& mesh, int triangles);
} // namespace interlock::dem
