// The facets of a surface file, whichever of the known formats it has.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/input_file.h"

namespace interlock::dem
{
// The facets as they are in an STL, PLY or OBJ file, in file units: nothing merged, dropped or
// judged, so open surfaces are as welcome as closed ones. Throws InputError when the extension is
// none of the three, the content is another format, or the file is damaged.
TriangleMesh read_facets(const InputFile& file);
} // namespace interlock::dem
