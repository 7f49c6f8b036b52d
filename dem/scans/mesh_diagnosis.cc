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

int count_parts(ConnectedParts& parts, int items)
{
  int count = 0;
  for (int item = 0; item < items; ++item) count += parts.part(item) == item;
  return count;
}

void find_shells(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& touching,
                 MeshDiagnosis& diagnosis)
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
  diagnosis.volume = 0;
  for (const double volume : volumes) {
    diagnosis.volume += volume;
    sum_of_sizes += std::abs(volume);
    largest = std::max(largest, std::abs(volume));
  }
  const int vertices = static_cast<int>(volumes.size());
  diagnosis.shells = count_parts(parts, vertices);
  for (const auto& pair : touching) parts.join(pair[0], pair[1]);
  diagnosis.groups_of_shells = count_parts(parts, vertices);
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

std::string gap_sentence(double gap)
{
  std::ostringstream text;
  text.precision(3);
  text << ", but its corners nearly meet (largest gap " << 1e3 * gap
       << " mm): merge corners that are at most that far apart before making a clump.";
  return text.str();
}

std::string shells_sentence(const MeshDiagnosis& diagnosis)
{
  if (diagnosis.groups_of_shells == diagnosis.shells) return " separate closed surfaces";
  const std::string corners = diagnosis.corners_parted == 1
                                  ? "one corner"
                                  : std::to_string(diagnosis.corners_parted) + " single corners";
  return diagnosis.groups_of_shells == 1
             ? " closed surfaces that touch each other in " + corners + " only"
             : " closed surfaces, some of which touch each other in " + corners + " only";
}
} // namespace

void diagnose_surface(const TriangleMesh& mesh, MeshDiagnosis& diagnosis,
                      const std::vector<std::array<int, 2>>& touching)
{
  if (mesh.triangles.empty()) return;
  diagnosis.edges = diagnose_edges(mesh);
  diagnosis.facets_without_area = count_facets_without_area(mesh);
  find_shells(mesh, touching, diagnosis);
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
         << (diagnosis.largest_gap > 0 ? gap_sentence(diagnosis.largest_gap)
                                       : "; close the holes before making a clump.");
  else if (edges.branching > 0)
    text << "is not a surface: " << edges.branching << " edges have more than two facets.";
  else if (edges.flipped > 0)
    text << "is not consistently oriented: at " << edges.flipped
         << " edges the two facets disagree about which side is outside.";
  else if (diagnosis.shells > 1)
    text << "has " << diagnosis.shells << shells_sentence(diagnosis) << ", the largest with "
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
