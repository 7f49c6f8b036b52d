#include "dem/scans/facet_file.h"

#include "dem/scans/obj_file.h"
#include "dem/scans/ply_file.h"
#include "dem/scans/stl_file.h"

namespace interlock::dem
{
TriangleMesh read_facets(const InputFile& file)
{
  const std::string extension = file.extension();
  if (extension != ".stl" && extension != ".ply" && extension != ".obj")
    file.refuse("has the extension ", quoted(extension), ", but must be .stl, .ply or .obj.");
  const std::string content = file.content();
  const bool is_ply = content == "a PLY file", is_stl = content == "an STL mesh";
  if (!content.empty() && !(is_ply && extension == ".ply") && !(is_stl && extension == ".stl"))
    file.refuse("cannot be read as a mesh: its extension is ", extension, ", but it is ", content,
                is_ply || is_stl ? "; rename it." : ".");
  if (extension == ".stl") return read_stl(file);
  if (extension == ".obj") return read_obj(file);
  const PlyHeader header = read_ply_header(file);
  if (header.rows("face") == 0)
    file.refuse("has no facet: it is a cloud of ", header.rows("vertex"), " points.");
  return read_ply(file, header).mesh;
}
} // namespace interlock::dem
