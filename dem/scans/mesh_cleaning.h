// What can be mended in a scan without a question: vertices and facets that are there twice, and
// facets that close nothing.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// Gives vertices at exactly the same place one number, and drops those that no facet uses. What is
// left is ordered by first use. Returns by how many the vertices became fewer. No tolerance: that
// of near_corners.h is for surfaces that stay open.
int merge_vertices(TriangleMesh& mesh);

// Drops facets with two equal corners; the edges of their neighbours still meet. Returns how many.
int drop_degenerate_facets(TriangleMesh& mesh);

// Of facets with the same corners in the same sense all but the first are dropped. Returns how
// many. Two facets back to back are no duplicates: which of them is right cannot be known.
int drop_duplicate_facets(TriangleMesh& mesh);
} // namespace interlock::dem
