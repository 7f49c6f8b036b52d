// A triangle surface mesh and its diagnosis: reading scans, writing stones, checking that the surface is
// closed and outward.
#pragma once

#include "dem/vector.h"

#include <array>
#include <string>
#include <vector>

namespace interlock::dem
{
// Vertices [m], any frame; triangles are counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vector3> vertices;            // [m]
  std::vector<std::array<int, 3>> triangles; // indices into vertices
};

// Reads an STL, PLY or OBJ file through Assimp, merges coincident vertices and drops degenerate
// facets. `length_unit` is the length of one file unit in metres (0.001 for millimetres).
// Throws InputError with one sentence naming the file when it is missing, unreadable, not a mesh, has
// no facet, a NaN coordinate, is open (how many edges), or its size does not look like a stone (unit).
// An inside-out surface is an error too.
TriangleMesh read_stone_mesh(const std::string& path, double length_unit);

// Writes a binary STL, first under a temporary name, then renamed.
void write_stl(const std::string& path, const TriangleMesh& mesh);

// Number of edges that do not have exactly two facets with opposite directions; 0 for a closed,
// consistently oriented surface.
int count_open_edges(const TriangleMesh& mesh);
} // namespace interlock::dem
