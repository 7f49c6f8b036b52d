// Turns the edges of a mesh along the creases of the surface that it approximates.
#pragma once

#include "dem/meshes/triangle_mesh.h"

#include <functional>

namespace interlock::dem
{
// Two facets at an edge form a quadrangle; where the middle of its other diagonal lies clearly
// nearer to the surface, that diagonal takes the edge's place. Edges that zigzag over a crease so
// come to run along it. Nodes stay. `distance` tells how far a point is from the surface [m, >= 0].
// Facets keep facing away from the origin, as they do on a star-shaped body, and no sliver arises.
// The mesh must be closed.
void flip_edges(TriangleMesh& mesh, const std::function<double(const Vector3&)>& distance);
} // namespace interlock::dem
