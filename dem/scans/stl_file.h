// Stereolithography files (STL), binary and text.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/input_file.h"

namespace interlock::dem
{
// The facets in file units, each with three vertices of its own. Normals and attributes are left
// out: the order of the corners says where outside is. A file of 84 + 50 n bytes whose header says
// n facets is binary, whatever its title; a binary file of another length is refused, since it is
// cut short or damaged. Throws InputError.
TriangleMesh read_stl(const InputFile& file);
} // namespace interlock::dem
