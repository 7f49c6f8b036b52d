// Corners in which a surface touches itself, or another one.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// The facets around a corner of a surface make one fan, each sharing an edge with the next. Where
// two bodies meet in a single corner (grains of a CT scan that were taken for one, a hollow that
// comes up to the surface) there are several closed fans, and all edges are sound. Gives each fan
// but the first one (that of the facet that comes first in the file) a vertex of its own at the
// same place, appended to the vertices; what then hangs together by vertices hangs together by
// edges. Corners whose facets are no closed fans of one sense stay as they are. Returns the pairs
// (vertex, appended vertex) in ascending order.
std::vector<std::array<int, 2>> part_touching_corners(TriangleMesh& mesh);
} // namespace interlock::dem
