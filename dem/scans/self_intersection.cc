#include "dem/scans/self_intersection.h"

#include "dem/scans/facet_crossing.h"

// Boost 1.74 includes a header that it calls deprecated itself; this keeps the note out of the
// build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/function_output_iterator.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cstdint>

namespace interlock::dem
{
namespace
{
using FloatBox = Eigen::AlignedBox3f; // half the memory of double; only finds candidates

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
namespace bg = boost::geometry;
using Point = bg::model::point<float, 3, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Entry = std::pair<Box, int>; // around a run of facets; the place of its first one

// Compares facets with each other, run by run.
class Search
{
public:
  // One entry of the tree for a run of neighbours: an eighth of the entries and of the searches,
  // for 64 cheap comparisons of boxes where two runs come near each other.
  static constexpr int run = 8;

  explicit Search(const TriangleMesh& mesh)
      : mesh_(mesh), crossing_(mesh), order_(along_curve(mesh)), facets_(int(order_.size()))
  {
    boxes_.reserve(order_.size());
    for (const int t : order_)
      boxes_.push_back(box_around(mesh, mesh.triangles[t], crossing_.tolerance()));
  }

  std::vector<Entry> runs() const
  {
    std::vector<Entry> entries;
    for (int first = 0; first < facets_; first += run) {
      FloatBox box;
      for (int i = first; i < std::min(first + run, facets_); ++i) box.extend(boxes_[i]);
      const Point low(box.min()[0], box.min()[1], box.min()[2]);
      entries.emplace_back(Box(low, Point(box.max()[0], box.max()[1], box.max()[2])), first);
    }
    return entries;
  }

  void compare(int first, int second)
  {
    if (result.pairs >= most_pairs || (comparisons_left_ -= run * run) < 0) result.complete = false;
    if (!result.complete) return;
    for (int i = first; i < std::min(first + run, facets_); ++i)
      for (int j = std::max(second, i + 1); j < std::min(second + run, facets_); ++j) {
        if (!boxes_[i].intersects(boxes_[j])) continue;
        comparisons_left_ -= 20; // boxes are quicker to compare than facets
        const auto point = crossing_(mesh_.triangles[order_[i]], mesh_.triangles[order_[j]]);
        if (point && result.pairs++ == 0) result.point = *point;
      }
  }

  SelfIntersection result;

private:
  static constexpr int most_pairs = 10000;

  const TriangleMesh& mesh_;
  const FacetCrossing crossing_;
  const std::vector<int> order_; // facets along the curve
  const int facets_;
  std::vector<FloatBox> boxes_; // in this order
  std::int64_t comparisons_left_ = 1000000000;
};
} // namespace

SelfIntersection find_self_intersection(const TriangleMesh& mesh)
{
  if (mesh.triangles.empty()) return {};
  Search search(mesh);
  const std::vector<Entry> runs = search.runs();
  const bg::index::rtree<Entry, bg::index::linear<16>> tree(runs);
  for (const Entry& entry : runs) {
    if (!search.result.complete) break;
    const auto compare = [&](const Entry& other) {
      if (other.second >= entry.second) search.compare(entry.second, other.second);
    };
    tree.query(bg::index::intersects(entry.first), boost::make_function_output_iterator(compare));
  }
  return search.result;
}
} // namespace interlock::dem
