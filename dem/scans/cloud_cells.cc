#include "dem/scans/cloud_cells.h"

// Boost 1.74 includes a header that it calls deprecated itself; this keeps the note out of the
// build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/function_output_iterator.hpp>
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras_point_box.hpp>

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Point, int>;
using Tree = bg::index::rtree<Entry, bg::index::quadratic<16>>;
using Vector2 = Eigen::Vector2d;
using Polygon = std::vector<Vector2>;

constexpr int neighbours = 24;
// Cosine between two normals below which they belong to opposite sides of the stone. Beyond the
// right angle, so that the faces at a square edge see each other despite noise.
constexpr double other_side = -0.3;
// And below which there is a sharp edge between the points.
constexpr double beyond_edge = 0.8;
// Nearest neighbours that tell the scatter: about as many as share an edge of the cell.
constexpr int close_neighbours = 6;

Point to_point(const Vector3& x)
{
  return {x[0], x[1], x[2]};
}

Tree tree_of(const std::vector<Vector3>& points)
{
  std::vector<Entry> entries;
  for (const Vector3& x : points) entries.emplace_back(to_point(x), int(entries.size()));
  return Tree(entries);
}

// What of the convex polygon has y.direction <= limit (Sutherland and Hodgman, one edge).
void clip(Polygon& polygon, Polygon& scratch, const Vector2& direction, double limit)
{
  scratch.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double from = a.dot(direction) - limit, to = b.dot(direction) - limit;
    if (from <= 0) scratch.push_back(a);
    if (from * to < 0) scratch.push_back(a + from / (from - to) * (b - a));
  }
  polygon.swap(scratch);
}

// The cells one after the other, each as a fan of triangles around its point.
class Cells
{
public:
  explicit Cells(const PointCloud& cloud) : cloud_(cloud), tree_(tree_of(cloud.points)) {}

  void append(int point)
  {
    find_neighbours(point);
    const Vector3 &x = cloud_.points[point], &n = cloud_.normals[point];
    const Vector3 first = n.unitOrthogonal(), second = n.cross(first);
    double reach = 0;
    for (const int other : found_) reach = std::max(reach, (cloud_.points[other] - x).norm());
    polygon_ = {{reach, reach}, {-reach, reach}, {-reach, -reach}, {reach, -reach}};
    for (const int other : found_) {
      if (cloud_.normals[other].dot(n) < other_side) continue;
      const Vector3 offset = cloud_.points[other] - x;
      const Vector2 along(offset.dot(first), offset.dot(second));
      const bool is_beyond_edge = cloud_.normals[other].dot(n) < beyond_edge;
      clip(polygon_, scratch_, along,
           offset.norm() * (is_beyond_edge ? offset.norm() : along.norm()) / 2);
    }
    append_fan(x, first, second);
    add_heights(point);
  }

  // Mean distance of close neighbours, and scatter of the points along their normals [m].
  double spacing() const { return pairs_ > 0 ? distances_ / pairs_ : 0; }
  double scatter() const { return pairs_ > 0 ? std::sqrt(squared_heights_ / pairs_ / 2) : 0; }

  int disagreeing = 0;
  TriangleMesh fans;

private:
  void find_neighbours(int point)
  {
    found_.clear();
    int against = 0;
    tree_.query(bg::index::nearest(to_point(cloud_.points[point]), neighbours + 1),
                boost::make_function_output_iterator([&](const Entry& entry) {
                  if (entry.second == point) return;
                  found_.push_back(entry.second);
                  against += cloud_.normals[entry.second].dot(cloud_.normals[point]) < 0;
                }));
    if (2 * against > static_cast<int>(found_.size())) ++disagreeing;
  }

  void add_heights(int point)
  {
    const Vector3 &x = cloud_.points[point], &n = cloud_.normals[point];
    // The tree gives the neighbours in no order.
    std::sort(found_.begin(), found_.end(), [&](int a, int b) {
      return (cloud_.points[a] - x).squaredNorm() < (cloud_.points[b] - x).squaredNorm();
    });
    for (std::size_t k = 0; k < found_.size() && k < close_neighbours; ++k) {
      const Vector3 offset = cloud_.points[found_[k]] - x, &other = cloud_.normals[found_[k]];
      if (other.dot(n) < beyond_edge) continue;
      const double height = offset.dot(n + other) / 2;
      squared_heights_ += height * height, distances_ += offset.norm(), ++pairs_;
    }
  }

  void append_fan(const Vector3& x, const Vector3& first, const Vector3& second)
  {
    const int start = static_cast<int>(fans.vertices.size());
    const int corners = static_cast<int>(polygon_.size());
    for (const Vector2& y : polygon_) fans.vertices.push_back(x + y[0] * first + y[1] * second);
    for (int k = 1; k + 1 < corners; ++k)
      fans.triangles.push_back({start, start + k, start + k + 1});
  }

  const PointCloud& cloud_;
  const Tree tree_;
  std::vector<int> found_;
  Polygon polygon_, scratch_;
  double squared_heights_ = 0, distances_ = 0; // [m2], [m]
  int pairs_ = 0;
};
} // namespace

CloudProperties cloud_properties(const PointCloud& cloud)
{
  Cells cells(cloud);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) cells.append(static_cast<int>(i));

  CloudProperties result;
  result.disagreeing_normals = cells.disagreeing;
  result.spacing = cells.spacing();
  result.scatter = cells.scatter();
  if (result.spacing > 0) result.volume_excess = 2.5 * std::pow(result.scatter / result.spacing, 2);
  // The cones over the cells' polygons: for a plane cell their volume is a x.n / 3.
  result.body = mass_properties(cells.fans);
  Vector3 sum = Vector3::Zero();
  for (const auto& t : cells.fans.triangles) {
    const Vector3 &a = cells.fans.vertices[t[0]], &b = cells.fans.vertices[t[1]],
                  &c = cells.fans.vertices[t[2]];
    const Vector3 twice_area = (b - a).cross(c - a);
    sum += twice_area / 2;
    result.area += twice_area.norm() / 2;
  }
  if (result.area > 0) result.closure = sum.norm() / result.area;
  return result;
}
} // namespace interlock::dem
