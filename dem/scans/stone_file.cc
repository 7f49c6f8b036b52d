#include "dem/scans/stone_file.h"

#include "dem/scans/facet_file.h"
#include "dem/scans/input_file.h"
#include "dem/scans/mesh_cleaning.h"

#include <cmath>

namespace interlock::dem
{
namespace
{
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
