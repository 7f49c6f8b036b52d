#include "dem/scans/near_corners.h"

#include "dem/scans/mesh_cleaning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace interlock::dem
{
namespace
{
// Corners that stand for others, in cells of twice the tolerance. They are further apart than the
// tolerance, so that a cell holds a handful of them at most.
class Leaders
{
public:
  Leaders(const std::vector<Vector3>& points, const Vector3& origin, double tolerance,
          std::size_t most)
      : points_(points), origin_(origin), tolerance_(tolerance), first_(slots_for(most), -1)
  {
  }

  // The nearest leader within the tolerance; -1 if there is none.
  int near(int point) const
  {
    const Vector3& x = points_[point];
    const Vector3 room = Vector3::Constant(tolerance_);
    const Cell low = cell(x - room), high = cell(x + room);
    int nearest = -1;
    double least = tolerance_ * tolerance_;
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
          for (int entry = first_[slot({i, j, k})]; entry >= 0; entry = entries_[entry].next) {
            const int leader = entries_[entry].point;
            const double squared = (points_[leader] - x).squaredNorm();
            if (squared > least || (squared == least && nearest >= 0 && leader > nearest)) continue;
            least = squared;
            nearest = leader;
          }
    return nearest;
  }

  void add(int point)
  {
    int& first = first_[slot(cell(points_[point]))];
    entries_.push_back({point, first});
    first = static_cast<int>(entries_.size()) - 1;
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    int point, next; // in the same slot
  };

  static std::size_t slots_for(std::size_t most)
  {
    std::size_t size = 1;
    while (size < most) size *= 2;
    return size;
  }

  Cell cell(const Vector3& x) const
  {
    Cell result;
    for (int k = 0; k < 3; ++k)
      result[k] = static_cast<std::int64_t>(std::floor((x[k] - origin_[k]) / (2 * tolerance_)));
    return result;
  }

  std::size_t slot(const Cell& cell) const
  {
    std::uint64_t h = 0;
    for (const std::int64_t index : cell) {
      h = (h ^ static_cast<std::uint64_t>(index)) * 0x9E3779B97F4A7C15u;
      h ^= h >> 29;
    }
    return h & (first_.size() - 1);
  }

  const std::vector<Vector3>& points_;
  const Vector3 origin_;
  const double tolerance_;
  std::vector<int> first_; // entry of each slot
  std::vector<Entry> entries_;
};

// The vertices of edges that have one facet, ascending.
std::vector<int> rim_of(const TriangleMesh& mesh)
{
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({low, high});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<int> rim;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    if (last - first == 1) rim.insert(rim.end(), edges[first].begin(), edges[first].end());
  }
  std::sort(rim.begin(), rim.end());
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  return rim;
}
} // namespace

JoinedSurface join_near_corners(const TriangleMesh& mesh, double tolerance)
{
  JoinedSurface result;
  result.mesh = mesh;
  result.edges = diagnose_edges(mesh);
  const std::vector<int> rim = rim_of(mesh);
  if (rim.empty() || !(tolerance > 0)) return result;
  Leaders leaders(mesh.vertices, mesh.vertices[rim.front()], tolerance, rim.size());
  std::vector<int> stands_for(mesh.vertices.size());
  for (std::size_t v = 0; v < stands_for.size(); ++v) stands_for[v] = static_cast<int>(v);
  for (const int v : rim) {
    const int leader = leaders.near(v);
    if (leader < 0) {
      leaders.add(v);
      continue;
    }
    stands_for[v] = leader;
    ++result.joined;
    result.largest_gap =
        std::max(result.largest_gap, (mesh.vertices[v] - mesh.vertices[leader]).norm());
  }
  if (result.joined == 0) return result;
  for (auto& triangle : result.mesh.triangles)
    for (int& v : triangle) v = stands_for[v];
  result.degenerate_facets = drop_degenerate_facets(result.mesh);
  result.duplicate_facets = drop_duplicate_facets(result.mesh);
  merge_vertices(result.mesh); // drops those that gave way
  result.edges = diagnose_edges(result.mesh);
  return result;
}

double closing_gap(const TriangleMesh& mesh)
{
  const double extent = extents(mesh).maxCoeff();
  const int branching = diagnose_edges(mesh).branching;
  for (double share = 10 * joined_gap; share < 2 * largest_near_gap; share *= 10) {
    const JoinedSurface joined = join_near_corners(mesh, share * extent);
    if (joined.edges.open == 0 && joined.edges.branching <= branching &&
        joined.degenerate_facets == 0)
      return joined.largest_gap;
  }
  return 0;
}
} // namespace interlock::dem
