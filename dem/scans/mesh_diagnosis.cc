#include "dem/scans/mesh_diagnosis.h"

#include "dem/meshes/connected_parts.h"

#include <algorithm>
#include <sstream>

namespace interlock::dem
{
namespace
{
// Six times the volume between a facet and `apex`.
double six_volumes(const TriangleMesh& mesh, const std::array<int, 3>& t, const Vector3& apex)
{
  const Vector3 a = mesh.vertices[t[0]] - apex, b = mesh.vertices[t[1]] - apex,
                c = mesh.vertices[t[2]] - apex;
  return a.dot(b.cross(c));
}

void find_shells(const TriangleMesh& mesh, MeshDiagnosis& diagnosis)
{
  ConnectedParts parts(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  const Vector3 apex = mesh.vertices.front(); // near the body: costs no digits to cancellation
  std::vector<double> volumes(mesh.vertices.size(), 0); // by the vertex that stands for the shell
  for (const auto& t : mesh.triangles) volumes[parts.part(t[0])] += six_volumes(mesh, t, apex) / 6;
  double sum_of_sizes = 0, largest = 0;
  for (std::size_t v = 0; v < volumes.size(); ++v) {
    if (parts.part(static_cast<int>(v)) == static_cast<int>(v)) ++diagnosis.shells;
    diagnosis.volume += volumes[v];
    sum_of_sizes += std::abs(volumes[v]);
    largest = std::max(largest, std::abs(volumes[v]));
  }
  diagnosis.largest_shell_share = sum_of_sizes > 0 ? largest / sum_of_sizes : 0;
}

int count_facets_without_area(const TriangleMesh& mesh)
{
  return static_cast<int>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
        const Vector3 ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
        return ab.cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).isZero(0);
      }));
}

std::string fault_of_crossings(const SelfIntersection& crossings)
{
  std::ostringstream text;
  text << "crosses itself: " << (crossings.complete ? "" : "at least ") << crossings.pairs
       << (crossings.pairs == 1 ? " pair of facets cuts" : " pairs of facets cut")
       << " through each other, one of them near (" << crossings.point[0] << ", "
       << crossings.point[1] << ", " << crossings.point[2]
       << ") m; mend the surface there, or accept it with --accept-crossings.";
  return text.str();
}
} // namespace

void diagnose_surface(const TriangleMesh& mesh, MeshDiagnosis& diagnosis)
{
  if (mesh.triangles.empty()) return;
  diagnosis.edges = diagnose_edges(mesh);
  diagnosis.facets_without_area = count_facets_without_area(mesh);
  find_shells(mesh, diagnosis);
  if (diagnosis.closed() && diagnosis.shells == 1)
    diagnosis.crossings = find_self_intersection(mesh);
}

std::string fault_of(const MeshDiagnosis& diagnosis)
{
  std::ostringstream text;
  const EdgeDiagnosis& edges = diagnosis.edges;
  if (edges.open > 0)
    text << "is open: " << edges.open << " edges have a facet on one side only, around "
         << edges.holes << (edges.holes == 1 ? " hole" : " holes")
         << "; close the holes before making a clump.";
  else if (edges.branching > 0)
    text << "is not a surface: " << edges.branching << " edges have more than two facets.";
  else if (edges.flipped > 0)
    text << "is not consistently oriented: at " << edges.flipped
         << " edges the two facets disagree about which side is outside.";
  else if (diagnosis.shells > 1)
    text << "has " << diagnosis.shells << " separate closed surfaces, the largest with "
         << 100 * diagnosis.largest_shell_share
         << " % of the volume; keep the one that is the stone.";
  else if (diagnosis.volume < 0 && diagnosis.flipped)
    text << "is inside out with --flip (volume " << diagnosis.volume
         << " m3): its facets point outwards as they are in the file, so leave --flip away.";
  else if (diagnosis.volume < 0)
    text << "is inside out: its facets point inwards (volume " << diagnosis.volume
         << " m3); turn them with --flip.";
  else if (!(diagnosis.volume > 0))
    text << "encloses no volume.";
  else if (diagnosis.crossings.pairs > 0)
    return fault_of_crossings(diagnosis.crossings);
  return text.str();
}
} // namespace interlock::dem
