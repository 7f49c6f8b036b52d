#include "dem/largest_ball.h"

// Boost 1.74 includes a header that it calls deprecated itself; this keeps the note out of the
// build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras_point_box.hpp>

#include <limits>

namespace interlock::dem
{
namespace
{
namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Point, int>;

Point to_point(const Vector3& x)
{
  return {x[0], x[1], x[2]};
}

std::vector<Entry> entries(const std::vector<Vector3>& nodes)
{
  std::vector<Entry> result;
  for (const Vector3& node : nodes) result.emplace_back(to_point(node), int(result.size()));
  return result;
}
} // namespace

// Built from the whole range at once, which packs the tree tightly.
struct LargestBall::Tree {
  explicit Tree(const std::vector<Vector3>& nodes) : index(entries(nodes)) {}

  int nearest(const Vector3& x) const
  {
    return index.qbegin(bg::index::nearest(to_point(x), 1))->second;
  }

  bg::index::rtree<Entry, bg::index::quadratic<16>> index;
};

LargestBall::LargestBall(const std::vector<Vector3>& nodes)
    : nodes_(nodes), tree_(std::make_unique<Tree>(nodes))
{
  Eigen::AlignedBox3d box;
  for (const Vector3& node : nodes) box.extend(node);
  if (!nodes.empty()) half_diagonal_ = box.sizes().norm() / 2;
}

LargestBall::~LargestBall() = default;

double LargestBall::radius(int node, const Vector3& inward) const
{
  // Shrink from a ball that is too large: the node nearest to the centre is inside, if any is, and
  // limits the ball to a smaller one. What lies outside a ball lies outside the smaller one within
  // it, so the ball that ends up empty has the smallest radius of the definition.
  const Vector3& p = nodes_[node];
  double radius = half_diagonal_;
  bool limited = false;
  for (;;) {
    const Vector3 offset = nodes_[tree_->nearest(p + radius * inward)] - p;
    const double height = offset.dot(inward);
    // The node itself is nearest, or one behind the tangent plane by round-off: the ball is empty.
    if (!(height > 0)) break;
    const double smaller = offset.squaredNorm() / (2 * height);
    if (!(smaller < radius)) break;
    radius = smaller;
    limited = true;
  }
  return limited ? radius : std::numeric_limits<double>::infinity();
}

double LargestBall::distance_to_nodes(const Vector3& point) const
{
  return (nodes_[tree_->nearest(point)] - point).norm();
}
} // namespace interlock::dem
