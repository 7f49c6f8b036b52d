// Facets that cut through each other. Fails when a pair is missed or found twice, when neighbours
// or touching facets count, or when a crossing at a shared vertex goes unseen.
#include "dem/random_stream.h"
#include "dem/scans/self_intersection.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

int pairs(const std::vector<Vector3>& vertices, const std::vector<std::array<int, 3>>& triangles)
{
  return find_self_intersection({vertices, triangles}).pairs;
}

TEST(SelfIntersection, TwoFacets)
{
  // One in the plane z = 0; the other upright in y = 0.25, from z = -1 up to `top`.
  const auto count = [](double top) {
    return pairs(
        {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.2, 0.25, -1}, {0.2, 0.25, -1}, {0, 0.25, top}},
        {{0, 1, 2}, {3, 4, 5}});
  };
  EXPECT_EQ(count(1), 1);
  EXPECT_EQ(count(0), 0) << "touching with a corner";
  EXPECT_EQ(count(-0.1), 0);
}

TEST(SelfIntersection, PointLiesOnBothFacets)
{
  const SelfIntersection found = find_self_intersection(
      {{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.2, 0.25, -1}, {0.2, 0.25, -1}, {0, 0.25, 1}},
       {{0, 1, 2}, {3, 4, 5}}});
  EXPECT_TRUE(found.complete);
  EXPECT_LT((found.point - Vector3(0, 0.25, 0)).norm(), 1e-12);
}

TEST(SelfIntersection, SharedVertex)
{
  // Both facets start at vertex 0; the second one's far edge goes through the first one, or not.
  const std::vector<std::array<int, 3>> facets = {{0, 1, 2}, {0, 3, 4}};
  const Vector3 o(0, 0, 0), a(2, -1, 0), b(2, 1, 0);
  EXPECT_EQ(pairs({o, a, b, {1, 0, -1}, {1, 0, 1}}, facets), 1);
  EXPECT_EQ(pairs({o, a, b, {1, 0, 1}, {1, 0.5, 1}}, facets), 0);
  EXPECT_EQ(pairs({o, a, b, {-1, 0, -1}, {-1, 0, 1}}, facets), 0) << "straddles the plane behind";
}

TEST(SelfIntersection, OnePlaneDoesNotCount)
{
  EXPECT_EQ(pairs({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.1, 0.1, 0}, {2.1, 0.1, 0}, {0.1, 2.1, 0}},
                  {{0, 1, 2}, {3, 4, 5}}),
            0);
}

TEST(SelfIntersection, SoundBodiesHaveNone)
{
  EXPECT_EQ(find_self_intersection(solids::subdivide(solids::octahedron(0.04), 30)).pairs, 0);
  EXPECT_EQ(find_self_intersection(solids::box(1, 2, 3)).pairs, 0);
  // Turned, and rounded to single precision as in a file: faces are no longer quite plane.
  TriangleMesh box = solids::moved(
      solids::subdivide(solids::box(0.03, 0.04, 0.05), 15),
      Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix(), Vector3(1, 2, 3));
  for (Vector3& x : box.vertices) x = x.cast<float>().cast<double>();
  EXPECT_EQ(find_self_intersection(box).pairs, 0);
}

double six_volumes(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

// Whether an edge of `s` goes through `t`, from signs of volumes alone.
bool pierces(const std::vector<Vector3>& x, const std::array<int, 3>& s,
             const std::array<int, 3>& t)
{
  for (int k = 0; k < 3; ++k) {
    const Vector3 &p = x[s[k]], &q = x[s[(k + 1) % 3]];
    const Vector3 &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
    if (six_volumes(a, b, c, p) * six_volumes(a, b, c, q) > 0) continue;
    const bool first = six_volumes(p, q, a, b) > 0, second = six_volumes(p, q, b, c) > 0,
               third = six_volumes(p, q, c, a) > 0;
    if (first == second && second == third) return true;
  }
  return false;
}

TEST(SelfIntersection, AgreesWithAllPairsOfRandomFacets)
{
  RandomStream generator(1);
  const auto point = [&](double reach) {
    return Vector3(generator.uniform(-reach, reach), generator.uniform(-reach, reach),
                   generator.uniform(-reach, reach));
  };
  TriangleMesh mesh;
  for (int t = 0; t < 1000; ++t) {
    const Vector3 centre = point(1);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(centre + point(0.2));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  int expected = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      expected += pierces(mesh.vertices, mesh.triangles[i], mesh.triangles[j]) ||
                  pierces(mesh.vertices, mesh.triangles[j], mesh.triangles[i]);
  EXPECT_GT(expected, 100);
  EXPECT_EQ(find_self_intersection(mesh).pairs, expected);
}
} // namespace
