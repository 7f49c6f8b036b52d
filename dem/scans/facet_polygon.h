// Facets with more than three corners, cut into triangles.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// Appends the polygon with these vertices of `mesh` (each a valid index) as a fan of triangles that
// all turn the same way as the polygon; fewer than three corners close nothing and are left out.
// Returns an empty string, or why it cannot ("a concave facet with 7 corners"): no corner sees all
// others, or there are more than 100 of them, where the search would take long.
std::string append_polygon(const std::vector<int>& corners, TriangleMesh& mesh);
} // namespace interlock::dem
