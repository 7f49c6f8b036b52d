// Nearest points on facets against all facets one by one. Fails when the tree or its single
// precision misses a facet, or a filter lets the wrong ones pass.
#include "dem/generator/surface_tree.h"
#include "dem/random_stream.h"
#include "dem/stones/synthetic_stone.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

double distance_by_definition(const TriangleMesh& mesh, const Vector3& x)
{
  double distance = INFINITY;
  for (const auto& t : mesh.triangles)
    distance = std::min(
        distance,
        (nearest_on_triangle(x, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]) - x)
            .norm());
  return distance;
}

// Face, edges and corners of one triangle, by hand.
TEST(NearestOnTriangle, FaceEdgesAndCorners)
{
  const Vector3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  const auto expect = [&](const Vector3& x, const Vector3& nearest) {
    EXPECT_LT((nearest_on_triangle(x, a, b, c) - nearest).norm(), 1e-15) << x.transpose();
  };
  expect({0.5, 0.5, 3}, {0.5, 0.5, 0});
  expect({1, -1, 1}, {1, 0, 0});
  expect({2, 2, -1}, {1, 1, 0});
  expect({-1, 1, 0}, {0, 1, 0});
  expect({-1, -1, 0}, a);
  expect({5, -1, 0}, b);
  expect({0, 5, 2}, c);
  // Without area: the segment that is left.
  EXPECT_LT((nearest_on_triangle({1, 1, 0}, a, b, b) - Vector3(1, 0, 0)).norm(), 1e-15);
}

TEST(SurfaceTree, EqualsTheMinimumOverAllFacets)
{
  RandomStream random(1);
  // Far from the origin, as scans are.
  const TriangleMesh stone =
      solids::moved(make_stones(1, 7)[0], Matrix3::Identity(), Vector3(3, -2, 1));
  const SurfaceTree tree(stone);
  for (int n = 0; n < 300; ++n) {
    const Vector3 x = Vector3(3, -2, 1) + random.uniform(0, 0.05) * random.direction();
    const double exact = distance_by_definition(stone, x);
    EXPECT_EQ(tree.nearest(x, 1).distance, exact);
    EXPECT_EQ(tree.nearest(x, 0.999999 * exact).facet, -1);
    EXPECT_GE(tree.nearest(x, 1.000001 * exact).facet, 0);
  }
}

TEST(SurfaceTree, FiltersByNodeAndDirection)
{
  const TriangleMesh box = solids::box(2, 2, 2);
  const SurfaceTree tree(box);
  const int corner = 0; // at (-1, -1, -1): its facets are on the three low faces
  const Vector3 x(0.1, -0.9, 0.1), up(0, 0, 1);
  using Facets = SurfaceTree::Facets;
  EXPECT_NEAR(tree.nearest(x, 9).distance, 0.1, 1e-15);
  // Ahead along z: the upper face only.
  EXPECT_NEAR(tree.nearest(x, 9, Facets::ahead, corner, up).distance, 0.9, 1e-15);
  EXPECT_NEAR(tree.nearest(x, 9, Facets::beside, corner, up).distance, 0.9, 1e-15);
  EXPECT_TRUE(tree.is_outward(corner, Vector3(-1, -1, -1).normalized()));
  EXPECT_FALSE(tree.is_outward(corner, Vector3(-1, 1, -1).normalized()));
}
} // namespace
