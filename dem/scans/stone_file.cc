#include "dem/scans/stone_file.h"

#include "dem/scans/facet_file.h"
#include "dem/scans/input_file.h"
#include "dem/scans/mesh_cleaning.h"
#include "dem/scans/near_corners.h"
#include "dem/scans/resolution.h"
#include "dem/scans/touching_corners.h"

#include <cmath>

namespace interlock::dem
{
namespace
{
void mend(TriangleMesh& mesh, MeshDiagnosis& diagnosis)
{
  diagnosis.facets_read = static_cast<int>(mesh.triangles.size());
  diagnosis.vertices_merged = merge_vertices(mesh);
  diagnosis.degenerate_facets_dropped = drop_degenerate_facets(mesh);
  diagnosis.duplicate_facets_dropped = drop_duplicate_facets(mesh);
}

void to_metres(TriangleMesh& mesh, const StoneFileOptions& options, MeshDiagnosis& diagnosis)
{
  diagnosis.flipped = options.flip;
  for (Vector3& x : mesh.vertices) x *= options.length_unit;
  if (options.flip)
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

// Keeps what joining makes of the surface only when it is a better one: fewer open edges, and no
// edge more with too many facets.
void join_corners(TriangleMesh& mesh, MeshDiagnosis& diagnosis)
{
  JoinedSurface joined = join_near_corners(mesh, joined_gap * extents(mesh).maxCoeff());
  if (joined.edges.open >= diagnosis.edges.open ||
      joined.edges.branching > diagnosis.edges.branching)
    return;
  mesh = std::move(joined.mesh);
  diagnosis.edges = joined.edges;
  diagnosis.corners_joined = joined.joined;
  diagnosis.degenerate_facets_dropped += joined.degenerate_facets;
  diagnosis.duplicate_facets_dropped += joined.duplicate_facets;
  std::ostringstream note;
  note.precision(3);
  note << joined.joined << " corners that nearly met (largest gap " << 1e3 * joined.largest_gap
       << " mm) were joined";
  diagnosis.notes.push_back(note.str());
}

void part_and_diagnose(TriangleMesh& mesh, MeshDiagnosis& diagnosis)
{
  const auto touching = part_touching_corners(mesh);
  diagnosis.corners_parted = 0;
  for (std::size_t k = 0; k < touching.size(); ++k)
    diagnosis.corners_parted += k == 0 || touching[k][0] != touching[k - 1][0];
  diagnose_surface(mesh, diagnosis, touching);
}

void find_surface(TriangleMesh& mesh, MeshDiagnosis& diagnosis)
{
  part_and_diagnose(mesh, diagnosis);
  if (diagnosis.edges.open > 0) {
    join_corners(mesh, diagnosis);
    if (diagnosis.corners_joined > 0) part_and_diagnose(mesh, diagnosis);
    if (diagnosis.edges.open > 0) diagnosis.largest_gap = closing_gap(mesh);
  }
  if (diagnosis.shells == 1 && diagnosis.corners_parted > 0)
    diagnosis.notes.push_back("its surface touches itself in " +
                              std::to_string(diagnosis.corners_parted) +
                              (diagnosis.corners_parted == 1 ? " corner" : " corners"));
}

// What was noted may be why the surface has the fault.
std::string with_notes(std::string fault, const std::vector<std::string>& notes)
{
  if (fault.back() == '.') fault.pop_back();
  for (std::size_t k = 0; k < notes.size(); ++k) fault += (k == 0 ? " (note: " : "; ") + notes[k];
  return fault + (notes.empty() ? "." : ").");
}
} // namespace

TriangleMesh read_stone_mesh(const std::string& path, const StoneFileOptions& options,
                             MeshDiagnosis* diagnosis)
{
  InputFile file("Stone mesh", path);
  check_length_unit(file, options.length_unit);
  FacetData data = read_facets(file);
  TriangleMesh& mesh = data.mesh;
  file.release();
  MeshDiagnosis found;
  found.notes = std::move(data.notes);
  mend(mesh, found);
  if (diagnosis) *diagnosis = found;
  if (found.facets_read == 0) file.refuse("has no facet.");
  if (mesh.triangles.empty())
    file.refuse("has no facet with an area: all ", found.facets_read,
                " have two corners at one place.");
  const std::string coarse =
      check_resolution(file, mesh.vertices, data.single_precision, options.length_unit);
  if (!coarse.empty()) found.notes.push_back(coarse);
  to_metres(mesh, options, found);
  check_stone_size(file, extents(mesh).maxCoeff(), options.length_unit);
  find_surface(mesh, found);
  if (diagnosis) *diagnosis = found;
  if (options.accept_crossings) found.crossings = {};
  const std::string fault = fault_of(found);
  if (!fault.empty()) file.refuse(with_notes(fault, found.notes));
  return std::move(mesh);
}

TriangleMesh closed_stone_mesh(TriangleMesh mesh, const StoneFileOptions& options,
                               MeshDiagnosis* diagnosis)
{
  const int nodes = static_cast<int>(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles)
    for (const int node : triangle)
      if (node < 0 || node >= nodes)
        throw InputError("The stone has a triangle with vertex " + std::to_string(node) +
                         ", but its vertices have the numbers 0 to " + std::to_string(nodes - 1) +
                         ".");
  for (const Vector3& x : mesh.vertices)
    if (!x.allFinite()) throw InputError("The stone has a vertex that is not a finite place.");
  MeshDiagnosis found;
  mend(mesh, found);
  if (mesh.triangles.empty()) throw InputError("The stone has no triangle with an area.");
  to_metres(mesh, options, found);
  const double extent = extents(mesh).maxCoeff();
  if (extent < smallest_stone || extent > largest_stone) {
    std::ostringstream text;
    text << "The stone is " << extent << " m long with a unit of " << options.length_unit
         << " m, but stones measure " << smallest_stone << " m to " << largest_stone
         << " m: check the length unit.";
    throw InputError(text.str());
  }
  find_surface(mesh, found);
  if (diagnosis) *diagnosis = found;
  if (options.accept_crossings) found.crossings = {};
  const std::string fault = fault_of(found);
  if (!fault.empty()) throw InputError("The stone " + with_notes(fault, found.notes));
  return mesh;
}

TriangleMesh read_stone_mesh(const std::string& path, double length_unit)
{
  StoneFileOptions options;
  options.length_unit = length_unit;
  return read_stone_mesh(path, options);
}
} // namespace interlock::dem
