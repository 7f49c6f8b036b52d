// Wavefront files (OBJ).
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/input_file.h"

namespace interlock::dem
{
// Vertices and facets in file units, facets cut into triangles; textures, normals, materials,
// groups, points and lines are skipped. A backslash at the end of a line continues it, with or
// without a blank in front. Vertices that no facet uses may be anything ("nan"). Throws InputError
// naming the line.
TriangleMesh read_obj(const InputFile& file);
} // namespace interlock::dem
