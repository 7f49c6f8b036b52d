#include "dem/scans/facet_file.h"

#include "dem/scans/obj_file.h"
#include "dem/scans/ply_file.h"
#include "dem/scans/stl_file.h"

namespace interlock::dem
{
FacetData read_facets(const InputFile& file)
{
  const std::string extension = file.extension();
  if (extension != ".stl" && extension != ".ply" && extension != ".obj")
    file.refuse("has the extension ", quoted(extension), ", but must be .stl, .ply or .obj.");
  // The title of a binary STL file may be anything, also what another format starts with.
  if (extension == ".stl" && is_binary_stl(file)) return read_stl(file);
  const std::string content = file.content();
  const bool is_ply = content == "a PLY file", is_stl = content == "an STL mesh";
  if (!content.empty() && !(is_ply && extension == ".ply") && !(is_stl && extension == ".stl"))
    file.refuse("cannot be read as a mesh: its extension is ", extension, ", but it is ", content,
                is_ply || is_stl ? "; rename it." : ".");
  if (extension == ".stl") return read_stl(file);
  if (extension == ".obj") return {read_obj(file), false, {}};
  const PlyHeader header = read_ply_header(file);
  if (!header.has_facets())
    file.refuse("has no facet: it is a cloud of ", header.rows("vertex"), " points",
                header.unknown_elements(), ".");
  PlyData data = read_ply(file, header);
  return {std::move(data.mesh), data.single_precision, {}};
}
} // namespace interlock::dem
