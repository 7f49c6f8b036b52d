// The largest ball at a node: among nodes, against the definition (minimum over all nodes) and
// solids where it is known; inside the surface, against solids where it is known and against all
// facets one by one. Fails when the search stops early, skips what limits the ball, takes something
// behind the tangent plane, or lets a ball stick out of a facet.
#include "dem/generator/largest_ball.h"
#include "dem/stones/synthetic_stone.h"
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

TEST(BallAmongNodes, EqualsTheMinimumOverAllNodesOfRandomStones)
{
  for (const TriangleMesh& stone : make_stones(3, 7)) {
    const BallAmongNodes balls(stone.vertices);
    const auto normals = node_normals(stone);
    for (std::size_t i = 0; i < stone.vertices.size(); ++i) {
      const double exact = radius_by_definition(stone.vertices, i, -normals[i]);
      ASSERT_NEAR(balls.radius(i, -normals[i]), exact, 1e-12 * exact) << "node " << i;
    }
  }
}

// 30 divides the faces such that their middles are nodes: the ball there is the insphere,
// a/sqrt(6).
TEST(BallAmongNodes, InsphereOfTheOctahedron)
{
  const double a = 0.04, insphere = a / std::sqrt(6.), spacing = a / 30;
  const TriangleMesh mesh = solids::subdivide(solids::octahedron(a), 30);
  const BallAmongNodes balls(mesh.vertices);
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

TEST(BallAmongNodes, NoNodeAheadMeansNoBall)
{
  const TriangleMesh mesh = solids::octahedron(0.04);
  EXPECT_TRUE(std::isinf(BallAmongNodes(mesh.vertices).radius(0, Vector3(1, 0, 0))));
}

// How far the ball sticks out of the surface: negative when it keeps clear of it [m].
double poke(const TriangleMesh& mesh, const Sphere& ball)
{
  double distance = INFINITY;
  for (const auto& t : mesh.triangles) {
    const Vector3 q = nearest_on_triangle(ball.centre, mesh.vertices[t[0]], mesh.vertices[t[1]],
                                          mesh.vertices[t[2]]);
    distance = std::min(distance, (q - ball.centre).norm());
  }
  return ball.radius - distance;
}

// A slab of 80 mm x 80 mm x 20 mm whose upper face has nodes; below there are two large facets.
// Among nodes alone, balls would pass through the lower face.
TriangleMesh slab()
{
  TriangleMesh mesh = solids::box(0.08, 0.08, 0.02);
  // A tent of four facets in place of the upper two, flat.
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const int middle = 8;
  mesh.vertices.push_back({0, 0, 0.01});
  for (const auto& [a, b] : {std::pair(4, 5), {5, 7}, {7, 6}, {6, 4}})
    mesh.triangles.push_back({a, b, middle});
  return mesh;
}

TEST(BallInsideSurface, HalfTheThicknessOfASlabOfLargeFacets)
{
  const TriangleMesh mesh = slab();
  ASSERT_EQ(count_open_edges(mesh), 0);
  const Sphere ball = BallInsideSurface(mesh).at(8, Vector3(0, 0, -1));
  EXPECT_NEAR(ball.radius, 0.01, 1e-12);
  EXPECT_LT(ball.centre.norm(), 1e-12);
  EXPECT_GT(BallAmongNodes(mesh.vertices).radius(8, Vector3(0, 0, -1)), 0.03);
}

// From a corner of a cube the ball grows until it touches the three far faces as it would be
// tangent there: s (1 + 1/sqrt(3)) = a; then it fits between the three near ones.
TEST(BallInsideSurface, CornerOfACube)
{
  const double a = 0.04;
  const TriangleMesh mesh = solids::box(a, a, a);
  const Vector3 inward = Vector3(1, 1, 1).normalized();
  const Sphere ball = BallInsideSurface(mesh).at(0, inward);
  const double s = a / (1 + 1 / std::sqrt(3.));
  EXPECT_LT((ball.centre - (mesh.vertices[0] + s * inward)).norm(), 1e-10);
  EXPECT_NEAR(ball.radius, s / std::sqrt(3.), 1e-10);
}

TEST(BallInsideSurface, NeverSticksOut)
{
  std::vector<TriangleMesh> meshes = make_stones(3, 7);
  meshes.push_back(solids::box(0.06, 0.05, 0.04));
  meshes.push_back(solids::octahedron(0.04));
  meshes.push_back(solids::subdivide(solids::octahedron(0.04), 6));
  meshes.push_back(solids::corner_tetrahedron(0.03, 0.04, 0.05));
  meshes.push_back(slab());
  for (const TriangleMesh& mesh : meshes) {
    const BallInsideSurface balls(mesh);
    const auto normals = node_normals(mesh);
    const std::size_t stride = std::max<std::size_t>(1, mesh.vertices.size() / 60);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += stride) {
      const Sphere ball = balls.at(i, -normals[i]);
      EXPECT_GT(ball.radius, 0);
      EXPECT_NEAR(poke(mesh, ball), 0, 1e-12) << "node " << i;
    }
  }
}

// On a fine mesh of a ball both radii are that of the ball, to the sagitta of a facet.
TEST(BallInsideSurface, AgreesWithNodesOnAFineMesh)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(1), 50);
  for (Vector3& x : mesh.vertices) x = 0.02 * x.normalized();
  ASSERT_GT(mesh.vertices.size(), 10000u);
  const BallInsideSurface inside(mesh);
  const BallAmongNodes among(mesh.vertices);
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 97) {
    const Vector3 inward = -mesh.vertices[i].normalized();
    EXPECT_NEAR(among.radius(i, inward), 0.02, 1e-9);
    EXPECT_NEAR(inside.at(i, inward).radius, 0.02, 0.01 * 0.02);
  }
}

TEST(BallInsideSurface, NoBallAlongANormalThatPointsOut)
{
  const TriangleMesh mesh = solids::octahedron(0.04);
  EXPECT_EQ(BallInsideSurface(mesh).at(0, Vector3(1, 0, 0)).radius, 0);
}
} // namespace
