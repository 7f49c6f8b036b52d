#include "dem/self_intersection.h"

// Boost 1.74 includes a header that it calls deprecated itself; this keeps the note out of the
// build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/function_output_iterator.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>

namespace interlock::dem
{
namespace
{
using Triangle = std::array<int, 3>;
using FloatBox = Eigen::AlignedBox3f; // half the memory of double; only finds candidates

class Crossing
{
public:
  explicit Crossing(const TriangleMesh& mesh) : mesh_(mesh)
  {
    double largest = 0;
    for (const Vector3& x : mesh.vertices) largest = std::max(largest, x.cwiseAbs().maxCoeff());
    tolerance_ = 2.4e-7 * largest;
  }

  double tolerance() const { return tolerance_; }

  // A point where the two facets cut through each other, if they do.
  std::optional<Vector3> operator()(const Triangle& a, const Triangle& b) const
  {
    int shared = 0;
    for (const int v : a) shared += std::count(b.begin(), b.end(), v);
    if (shared > 1) return {};
    const Vector3 normal_a = normal(a), normal_b = normal(b);
    const auto distances_a = distances(a, b, normal_b), distances_b = distances(b, a, normal_a);
    if (!straddles(distances_a) || !straddles(distances_b)) return {};
    const Vector3 along = normal_a.cross(normal_b).normalized();
    const Interval of_a = interval(a, distances_a, along), of_b = interval(b, distances_b, along);
    const double first = std::max(of_a.first, of_b.first), last = std::min(of_a.last, of_b.last);
    if (!(last - first > tolerance_)) return {};
    return Vector3(of_a.point + ((first + last) / 2 - of_a.point.dot(along)) * along);
  }

private:
  struct Interval {
    double first, last; // positions on the line where the planes meet
    Vector3 point;      // one of its ends
  };

  const Vector3& corner(const Triangle& t, int k) const { return mesh_.vertices[t[k]]; }

  Vector3 normal(const Triangle& t) const
  {
    const Vector3 ab = corner(t, 1) - corner(t, 0), ac = corner(t, 2) - corner(t, 0);
    return ab.cross(ac).normalized();
  }

  // Of the corners of `t` from the plane of `other`; zero for a shared vertex and within rounding.
  std::array<double, 3> distances(const Triangle& t, const Triangle& other,
                                  const Vector3& normal) const
  {
    std::array<double, 3> result;
    for (int k = 0; k < 3; ++k) {
      const double distance = normal.dot(corner(t, k) - corner(other, 0));
      const bool is_shared = std::find(other.begin(), other.end(), t[k]) != other.end();
      result[k] = is_shared || std::abs(distance) <= tolerance_ ? 0 : distance;
    }
    return result;
  }

  static bool straddles(const std::array<double, 3>& distances)
  {
    const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
    return *least < 0 && *most > 0;
  }

  // Where the facet, which has corners on either side, meets the other one's plane.
  Interval interval(const Triangle& t, const std::array<double, 3>& d, const Vector3& along) const
  {
    std::array<Vector3, 2> ends;
    int found = 0;
    for (int k = 0; k < 3 && found < 2; ++k) {
      const int next = (k + 1) % 3;
      if (d[k] == 0)
        ends[found++] = corner(t, k);
      else if (d[k] * d[next] < 0)
        ends[found++] = corner(t, k) + d[k] / (d[k] - d[next]) * (corner(t, next) - corner(t, k));
    }
    const double p = ends[0].dot(along), q = ends[1].dot(along);
    return {std::min(p, q), std::max(p, q), ends[0]};
  }

  const TriangleMesh& mesh_;
  double tolerance_;
};

// Places each of the lower ten bits three bits apart.
std::uint32_t spread(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000FF;
  x = (x | x << 8) & 0x0300F00F;
  x = (x | x << 4) & 0x030C30C3;
  return (x | x << 2) & 0x09249249;
}

// Facets in runs of neighbours: sorted along Morton's curve through their centres.
std::vector<int> along_curve(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& x : mesh.vertices) box.extend(x);
  const double scale = 1023 / box.sizes().maxCoeff() / 3;
  std::vector<std::pair<std::uint32_t, int>> keys;
  keys.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vector3 sum = mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]];
    const Eigen::Array3i cell = (scale * (sum - 3 * box.min())).array().cast<int>();
    const std::uint32_t key = spread(cell[0]) | spread(cell[1]) << 1 | spread(cell[2]) << 2;
    keys.emplace_back(key, static_cast<int>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

FloatBox box_around(const TriangleMesh& mesh, const Triangle& t, double margin)
{
  Eigen::AlignedBox3d box(mesh.vertices[t[0]]);
  box.extend(mesh.vertices[t[1]]).extend(mesh.vertices[t[2]]);
  const Vector3 room = Vector3::Constant(margin); // covers the rounding to float
  return {(box.min() - room).cast<float>(), (box.max() + room).cast<float>()};
}
} // namespace

SelfIntersection find_self_intersection(const TriangleMesh& mesh)
{
  namespace bg = boost::geometry;
  using Point = bg::model::point<float, 3, bg::cs::cartesian>;
  using Box = bg::model::box<Point>;
  using Entry = std::pair<Box, int>;
  // One entry of the tree for a run of neighbours: an eighth of the entries and of the searches,
  // for 64 cheap comparisons of boxes where two runs come near each other.
  constexpr int run = 8;
  constexpr int most_pairs = 10000;
  std::int64_t comparisons_left = 1000000000;

  const Crossing crossing(mesh);
  const std::vector<int> order = along_curve(mesh);
  const int facets = static_cast<int>(order.size());
  std::vector<FloatBox> boxes;
  boxes.reserve(facets);
  for (const int t : order)
    boxes.push_back(box_around(mesh, mesh.triangles[t], crossing.tolerance()));
  std::vector<Entry> entries;
  for (int first = 0; first < facets; first += run) {
    FloatBox box;
    for (int i = first; i < std::min(first + run, facets); ++i) box.extend(boxes[i]);
    const Point low(box.min()[0], box.min()[1], box.min()[2]);
    entries.emplace_back(Box(low, Point(box.max()[0], box.max()[1], box.max()[2])), first);
  }

  SelfIntersection result;
  const auto compare_runs = [&](int first, int second) {
    if (result.pairs >= most_pairs || (comparisons_left -= run * run) < 0) result.complete = false;
    if (!result.complete) return;
    for (int i = first; i < std::min(first + run, facets); ++i)
      for (int j = std::max(second, i + 1); j < std::min(second + run, facets); ++j) {
        if (!boxes[i].intersects(boxes[j])) continue;
        comparisons_left -= 20; // boxes are quicker to compare than facets
        const auto point = crossing(mesh.triangles[order[i]], mesh.triangles[order[j]]);
        if (point && result.pairs++ == 0) result.point = *point;
      }
  };
  const bg::index::rtree<Entry, bg::index::linear<16>> tree(entries);
  for (const Entry& entry : entries) {
    if (!result.complete) break;
    tree.query(bg::index::intersects(entry.first),
               boost::make_function_output_iterator([&](const Entry& other) {
                 if (other.second >= entry.second) compare_runs(entry.second, other.second);
               }));
  }
  return result;
}
} // namespace interlock::dem
