#include "dem/scans/stone_file.h"

#include "dem/scans/input_file.h"
#include "dem/scans/mesh_cleaning.h"
#include "dem/scans/obj_file.h"
#include "dem/scans/ply_file.h"
#include "dem/scans/stl_file.h"

#include <cmath>

namespace interlock::dem
{
namespace
{
// The facets as they are in the file.
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

void mend(TriangleMesh& mesh, const StoneFileOptions& options, MeshDiagnosis& diagnosis)
{
  diagnosis.facets_read = static_cast<int>(mesh.triangles.size());
  diagnosis.vertices_merged = merge_vertices(mesh);
  diagnosis.degenerate_facets_dropped = drop_degenerate_facets(mesh);
  diagnosis.duplicate_facets_dropped = drop_duplicate_facets(mesh);
  diagnosis.flipped = options.flip;
  for (Vector3& x : mesh.vertices) x *= options.length_unit;
  if (options.flip)
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}
} // namespace

TriangleMesh read_stone_mesh(const std::string& path, const StoneFileOptions& options,
                             MeshDiagnosis* diagnosis)
{
  InputFile file("Stone mesh", path);
  check_length_unit(file, options.length_unit);
  TriangleMesh mesh = read_facets(file);
  file.release();
  MeshDiagnosis found;
  mend(mesh, options, found);
  if (diagnosis) *diagnosis = found;
  if (mesh.triangles.empty()) file.refuse("has no facet.");
  check_stone_size(file, extents(mesh).maxCoeff(), options.length_unit);
  diagnose_surface(mesh, found);
  if (diagnosis) *diagnosis = found;
  if (options.accept_crossings) found.crossings = {};
  const std::string fault = fault_of(found);
  if (!fault.empty()) file.refuse(fault);
  return mesh;
}

TriangleMesh read_stone_mesh(const std::string& path, double length_unit)
{
  StoneFileOptions options;
  options.length_unit = length_unit;
  return read_stone_mesh(path, options);
}
} // namespace interlock::dem
