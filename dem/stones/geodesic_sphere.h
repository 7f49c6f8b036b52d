// Nearly even triangulations of the sphere, and their refinement.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// A sphere cut into 20 f^2 nearly equal triangles: each face of the icosahedron is cut into f^2 and
// blown up. 10 f^2 + 2 nodes, unit radius, outward.
TriangleMesh geodesic_sphere(int f);

// Every triangle cut into four at the middles of its edges. The old nodes come first.
TriangleMesh quartered(const TriangleMesh& mesh);
} // namespace interlock::dem
