// Wavefront files (OBJ).
#pragma once

#include "dem/scans/input_file.h"
#include "dem/triangle_mesh.h"

namespace interlock::dem
{
// Vertices and facets in file units, facets cut into triangles; textures, normals, materials,
// groups, points and lines are skipped. Throws InputError naming the line.
TriangleMesh read_obj(const InputFile& file);
} // namespace interlock::dem
