#include "dem/generator/largest_ball.h"

// Boost 1.74 includes a header that it calls deprecated itself; this keeps the note out of the
// build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras_point_box.hpp>

#include <algorithm>
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
struct BallAmongNodes::Tree {
  explicit Tree(const std::vector<Vector3>& nodes) : index(entries(nodes)) {}

  int nearest(const Vector3& x) const
  {
    return index.qbegin(bg::index::nearest(to_point(x), 1))->second;
  }

  bg::index::rtree<Entry, bg::index::quadratic<16>> index;
};

BallAmongNodes::BallAmongNodes(const std::vector<Vector3>& nodes)
    : nodes_(nodes), tree_(std::make_unique<Tree>(nodes))
{
  Eigen::AlignedBox3d box;
  for (const Vector3& node : nodes) box.extend(node);
  if (!nodes.empty()) half_diagonal_ = box.sizes().norm() / 2;
}

BallAmongNodes::~BallAmongNodes() = default;

double BallAmongNodes::radius(int node, const Vector3& inward) const
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

BallInsideSurface::BallInsideSurface(const TriangleMesh& mesh)
    : mesh_(mesh), nodes_(mesh.vertices), facets_(mesh)
{
}

Sphere BallInsideSurface::at(int node, const Vector3& inward) const
{
  using Facets = SurfaceTree::Facets;
  const Vector3& p = mesh_.vertices[node];
  if (!facets_.is_outward(node, -inward)) return {p, 0};
  // The ball that touches the node shrinks until it also touches a facet instead of holding a part
  // of it: to the ball through the node and that part's point nearest to the centre, again and
  // again. This is Newton's method for the touching radius, from above. Beside the node it is
  // ill-conditioned, hence the tolerance; ahead it is not.
  double s = std::min(nodes_.radius(node, inward), nodes_.half_diagonal());
  const auto shrink = [&](Facets which, double tolerance) {
    bool shrunk = false;
    for (;;) {
      const auto nearest =
          facets_.nearest(p + s * inward, (1 - tolerance) * s, which, node, inward);
      if (nearest.facet < 0) return shrunk;
      const Vector3 offset = nearest.point - p;
      const double smaller = offset.squaredNorm() / (2 * offset.dot(inward));
      if (!(smaller < s)) return shrunk;
      s = smaller;
      shrunk = true;
    }
  };
  shrink(Facets::ahead, 1e-12);
  if (shrink(Facets::beside, 0.01)) shrink(Facets::ahead, 1e-12);
  const Vector3 centre = p + s * inward;
  return {centre, facets_.nearest(centre, 2 * s).distance};
}
} // namespace interlock::dem
