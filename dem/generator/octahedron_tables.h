// Tables 1 to 3 of Ferellec and McDowell (2010): number of spheres in a regular octahedron.
#pragma once

#include "dem/meshes/triangle_mesh.h"

#include <cstdint>

namespace interlock::dem
{
// The paper gives neither the size of its octahedron nor its mesh. An edge of 40 mm and faces cut
// into 30^2 triangles (3602 nodes), whose nodes are moved by up to a tenth of their spacing, fit
// all three tables best of what was tried.
constexpr double octahedron_edge = 0.040; // [m]
constexpr int octahedron_divisions = 30;

// Around the origin, corners on the axes. Nodes are moved within their face or along their edge, so
// that the body stays the same. Deterministic from `seed`.
TriangleMesh irregular_octahedron(std::uint64_t seed);

struct OctahedronCell {
  double d_min, r_min; // [mm]
  double p_max;        // [%]
  int published;       // number of spheres
};
struct OctahedronTable {
  const char* title;
  std::vector<OctahedronCell> cells;
};
std::vector<OctahedronTable> published_octahedron_tables();

// Mean number of spheres over the seeds 1 to `seeds` of mesh and node order, with the paper's
// touching radius (among nodes).
double mean_sphere_count(const OctahedronCell& cell, int seeds = 6);
} // namespace interlock::dem
