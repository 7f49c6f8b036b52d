// The facets of a surface file, whichever of the known formats it has.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/input_file.h"

#include <vector>

namespace interlock::dem
{
struct FacetData {
  TriangleMesh mesh;             // file units
  bool single_precision = false; // the file keeps its coordinates so
  // What a reader left out or took for granted, each the end of a sentence ("its head promises no
  // facet, ...") without the full stop.
  std::vector<std::string> notes;
};

// The facets as they are in an STL, PLY or OBJ file: nothing merged, dropped or judged, so open
// surfaces are as welcome as closed ones. Throws InputError when the extension is none of the
// three, the content is another format, or the file is damaged.
FacetData read_facets(const InputFile& file);
} // namespace interlock::dem
