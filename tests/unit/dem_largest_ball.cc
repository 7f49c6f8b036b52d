// The shrinking ball against the definition (minimum over all nodes) and against solids where the
// largest ball is known. Fails when the search stops early, skips the limiting node or takes one
// behind the tangent plane.
#include "dem/largest_ball.h"
#include "dem/synthetic_stone.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

double radius_by_definition(const std::vector<Vector3>& nodes, int node, const Vector3& inward)
{
  double radius = INFINITY;
  for (const Vector3& q : nodes) {
    const Vector3 offset = q - nodes[node];
    if (offset.dot(inward) > 0)
      radius = std::min(radius, offset.squaredNorm() / (2 * offset.dot(inward)));
  }
  return radius;
}

TEST(LargestBall, EqualsTheMinimumOverAllNodesOfRandomStones)
{
  for (const TriangleMesh& stone : make_stones(3, 7)) {
    const LargestBall balls(stone.vertices);
    const auto normals = node_normals(stone);
    for (std::size_t i = 0; i < stone.vertices.size(); ++i) {
      const double exact = radius_by_definition(stone.vertices, i, -normals[i]);
      ASSERT_NEAR(balls.radius(i, -normals[i]), exact, 1e-12 * exact) << "node " << i;
    }
  }
}

// 30 divides the faces such that their middles are nodes: the ball there is the insphere,
// a/sqrt(6).
TEST(LargestBall, InsphereOfTheOctahedron)
{
  const double a = 0.04, insphere = a / std::sqrt(6.), spacing = a / 30;
  const TriangleMesh mesh = solids::subdivide(solids::octahedron(a), 30);
  const LargestBall balls(mesh.vertices);
  const auto normals = node_normals(mesh);
  int middles = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const double radius = balls.radius(i, -normals[i]);
    if (std::abs(mesh.vertices[i].norm() - insphere) < 1e-9) {
      ++middles;
      EXPECT_NEAR(radius, insphere, 1e-12 * insphere);
    }
    // Between the nodes of a face a ball can bulge out through an empty circle, which is at most
    // spacing/sqrt(3) wide, so by spacing^2/(6 r).
    EXPECT_LT(radius, insphere + 1.01 * spacing * spacing / (6 * insphere));
  }
  EXPECT_EQ(middles, 8);
}

TEST(LargestBall, NoNodeAheadMeansNoBall)
{
  const TriangleMesh mesh = solids::octahedron(0.04);
  EXPECT_TRUE(std::isinf(LargestBall(mesh.vertices).radius(0, Vector3(1, 0, 0))));
}

TEST(LargestBall, DistanceToNodes)
{
  const LargestBall balls(solids::box(2, 2, 2).vertices);
  EXPECT_NEAR(balls.distance_to_nodes(Vector3(1, 1, 4)), 3, 1e-14);
  EXPECT_NEAR(balls.distance_to_nodes(Vector3::Zero()), std::sqrt(3.), 1e-14);
}
} // namespace
