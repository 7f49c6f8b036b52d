// Synthetic stones are sound meshes with the grading of the paper. Fails when a stone is open or
// folded, when nodes are uneven, when sizes do not follow Table 5 by mass, or when a seed does not
// give the same stones again.
#include "dem/input_error.h"
#include "dem/mass_properties.h"
#include "dem/stone_size.h"
#include "dem/ballast_sizes.h"
#include "dem/synthetic_stone.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

class Stones : public testing::Test
{
protected:
  static void SetUpTestSuite() { stones_ = make_stones(41, 1); }
  static inline std::vector<TriangleMesh> stones_;
};

TEST_F(Stones, AreClosedOutwardAndNotFolded)
{
  for (const TriangleMesh& stone : stones_) {
    EXPECT_EQ(count_open_edges(stone), 0);
    const auto nodes = static_cast<long>(stone.vertices.size());
    EXPECT_EQ(nodes - long(stone.triangles.size()) / 2, 2); // Euler: one body, no handles
    EXPECT_GT(mass_properties(stone).volume, 0);
    EXPECT_LT(mass_properties(stone).centre.norm(), 1e-12);
    // Every facet is seen from the centre from behind, so none is folded over.
    for (const auto& t : stone.triangles) {
      const Vector3 &a = stone.vertices[t[0]], &b = stone.vertices[t[1]], &c = stone.vertices[t[2]];
      ASSERT_GT(a.dot(b.cross(c)), 0);
    }
  }
}

TEST_F(Stones, HaveEvenlySpacedNodes)
{
  for (const TriangleMesh& stone : stones_) {
    EXPECT_GE(stone.vertices.size(), 1442u);
    EXPECT_LE(stone.vertices.size(), 2892u);
    std::vector<double> lengths;
    for (const auto& t : stone.triangles)
      for (int k = 0; k < 3; ++k)
        lengths.push_back((stone.vertices[t[k]] - stone.vertices[t[(k + 1) % 3]]).norm());
    std::sort(lengths.begin(), lengths.end());
    const double median = lengths[lengths.size() / 2];
    EXPECT_GT(median, 0.001);
    EXPECT_LT(median, 0.0025);
    EXPECT_GT(lengths[lengths.size() / 100], 0.5 * median);
    EXPECT_LT(lengths[lengths.size() * 99 / 100], 2 * median);
  }
}

TEST_F(Stones, HaveTheSieveSizesAndProportionsAskedFor)
{
  std::vector<double> sizes;
  for (const TriangleMesh& stone : stones_) {
    const StoneSize size = stone_size(stone);
    sizes.push_back(size.sieve);
    // Drawn from 0.6-0.95 and 0.5-0.95 along x, y, z; the principal axes lie a little off them.
    EXPECT_GT(size.elongation(), 0.52);
    EXPECT_GT(size.flatness(), 0.42);
    // A ball has 1, a cube 0.81, a regular tetrahedron 0.67.
    EXPECT_GT(size.sphericity, 0.70);
    EXPECT_LT(size.sphericity, 0.95);
    const Vector3 box = extents(stone);
    EXPECT_GT(box[0], box[1] * 0.99);
    EXPECT_GT(box[1], box[2] * 0.99);
  }
  std::sort(sizes.begin(), sizes.end());
  const std::vector<double> wanted = ballast_sizes(41);
  for (int i = 0; i < 41; ++i) EXPECT_NEAR(sizes[i], wanted[i], 1e-9);
}

// Shares of mass (d^3 for like forms) in the classes of Table 5, in %.
std::vector<double> shares(const std::vector<double>& sizes)
{
  const std::vector<double> limits{0.022, 0.032, 0.040, 0.050, 0.0631};
  std::vector<double> result(limits.size(), 0);
  double total = 0;
  for (const double d : sizes) total += d * d * d;
  for (const double d : sizes)
    result[std::lower_bound(limits.begin(), limits.end(), d) - limits.begin()] +=
        100 * d * d * d / total;
  return result;
}

TEST(BallastSizes, FollowTable5ByMass)
{
  const std::vector<double> published{1, 18, 44, 32, 5};
  const auto many = shares(ballast_sizes(10000)), batch = shares(ballast_sizes(410));
  for (int c = 0; c < 5; ++c) {
    EXPECT_NEAR(many[c], published[c], 0.2);
    EXPECT_NEAR(batch[c], published[c], 1.5);
  }
}

// One stone of 12 is 10 to 20 % of the mass, so no class can be nearer than that.
TEST(BallastSizes, ADozenFollowsRoughly)
{
  const auto dozen = shares(ballast_sizes(12));
  const std::vector<double> published{1, 18, 44, 32, 5};
  for (int c = 0; c < 5; ++c) EXPECT_NEAR(dozen[c], published[c], 12) << c;
}

TEST(SyntheticStone, SeedDecides)
{
  const auto a = make_stones(2, 9), b = make_stones(2, 9), c = make_stones(2, 10);
  EXPECT_EQ(a[0].vertices, b[0].vertices);
  EXPECT_EQ(a[1].vertices, b[1].vertices);
  EXPECT_NE(a[0].vertices, c[0].vertices);
  EXPECT_THROW(make_stones(0, 1), interlock::InputError);
}

// End-on through a square hole: a nearly square section goes straight, a thin one along the
// diagonal, where the sides of the square are (b + c)/sqrt(2).
TEST(StoneSize, SieveOfABox)
{
  const Vector3 x(1, 0, 0);
  EXPECT_NEAR(sieve_size(solids::box(5, 4, 3).vertices, x), 4, 1e-4 * 4);
  EXPECT_NEAR(sieve_size(solids::box(5, 4, 1).vertices, x), 5 / std::sqrt(2.), 2e-3 * 4);
  const StoneSize size = stone_size(solids::box(2, 5, 4));
  EXPECT_NEAR(size.longest, 5, 1e-12);
  EXPECT_NEAR(size.elongation(), 0.8, 1e-12);
  EXPECT_NEAR(size.flatness(), 0.5, 1e-12);
  EXPECT_NEAR(size.sphericity, std::cbrt(M_PI * 36 * 1600) / 76, 1e-12);
}
} // namespace
