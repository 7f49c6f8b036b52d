// A triangle surface mesh and its diagnosis: reading scans, writing stones, checking that the
// surface is closed and outward.
#pragma once

#include "dem/vector.h"

#include <array>
#include <string>
#include <vector>

namespace interlock::dem
{
// Vertices [m], any frame; triangles are counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vector3> vertices;             // [m]
  std::vector<std::array<int, 3>> triangles; // indices into vertices
};

// Reads an STL, PLY or OBJ file: stone_file.h says what is mended, diagnosed and refused, and has
// the options. `length_unit` is the length of one file unit in metres (0.001 for millimetres).
TriangleMesh read_stone_mesh(const std::string& path, double length_unit);
constexpr double smallest_stone = 0.002; // largest extent of a stone at least [m]
constexpr double largest_stone = 1.0;    // and at most [m]

// Writes a binary STL (in metres, single precision), first under a temporary name, then renamed.
// Throws InputError when the file cannot be written.
void write_stl(const std::string& path, const TriangleMesh& mesh);

// Edges by what is wrong with them. A closed, consistently oriented surface has none.
struct EdgeDiagnosis {
  int open = 0;      // one facet only: the rim of a hole
  int flipped = 0;   // two facets that disagree about which side is outside
  int branching = 0; // more than two facets
  int holes = 0;     // rims: groups of open edges that hang together
};
EdgeDiagnosis diagnose_edges(const TriangleMesh& mesh);

// Number of edges that do not have exactly two facets with opposite directions; 0 for a closed,
// consistently oriented surface.
int count_open_edges(const TriangleMesh& mesh);

// Side lengths of the axis-parallel box around the vertices [m]; zero for a mesh without vertices.
Vector3 extents(const TriangleMesh& mesh);

// Area of the surface [m2].
double surface_area(const TriangleMesh& mesh);

// A third of the area of the facets around each vertex [m2]; they sum to that of the surface.
std::vector<double> node_areas(const TriangleMesh& mesh);

// Unit outward normal of each vertex: the mean of its facets' normals weighted by the angle at the
// vertex, so that it does not depend on how the faces are cut into triangles. Source: Thuermer and
// Wuethrich, J. Graphics Tools 3(1) (1998). Zero where the facets cancel or the vertex has none.
std::vector<Vector3> node_normals(const TriangleMesh& mesh);
} // namespace interlock::dem
