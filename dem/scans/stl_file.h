// Stereolithography files (STL), binary and text.
#pragma once

#include "dem/scans/facet_file.h"

namespace interlock::dem
{
// The facets in file units, each with three vertices of its own. Normals and attributes are left
// out: the order of the corners says where outside is. A file of 84 + 50 n bytes whose head says n
// facets is binary, whatever its title. Read with a note are binary files
// * whose head says 0 or 2^32 - 1 facets, as writers leave it that never come back to it, when the
//   bytes behind it are whole facets;
// * with padding behind the last facet: bytes that are all alike, or less than one facet.
// A binary file of another length is refused, since it is cut short or damaged: where more bytes
// than that follow, facets could get lost. Throws InputError.
FacetData read_stl(const InputFile& file);

// Whether the length is the one that the head of a binary file promises.
bool is_binary_stl(const InputFile& file);

// The text format alone.
TriangleMesh read_text_stl(const InputFile& file);

// A facet with three vertices of its own.
void append_triangle(const std::array<Vector3, 3>& corners, TriangleMesh& mesh);
} // namespace interlock::dem
