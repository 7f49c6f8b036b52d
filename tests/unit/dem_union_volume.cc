// Volume of unions of spheres against closed forms, with the error that is stated. Fails when
// overlaps count twice, the order of the spheres matters, or the stated error is too small.
#include "dem/generator/union_volume.h"
#include "dem/random_stream.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;
const double ball = 4. / 3 * M_PI; // of radius 1

// Two balls of radius 1 at distance d share a lens of volume pi (4 + d)(2 - d)^2/12.
double lens(double d)
{
  return M_PI * (4 + d) * std::pow(2 - d, 2) / 12;
}

void expect_volume(const std::vector<Sphere>& spheres, double exact)
{
  const UnionVolume all(spheres);
  EXPECT_LT(std::abs(all.volume() - exact), all.error());
  EXPECT_LT(all.error(), 5e-3 * exact);
}

TEST(UnionVolume, TwoBalls)
{
  for (const double d : {0.3, 1.3, 1.99})
    for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 0, 1), Vector3(0.6, 0, 0.8)})
      expect_volume({{{0, 0, 0}, 1}, {d * axis, 1}}, 2 * ball - lens(d));
}

TEST(UnionVolume, ApartAndWithin)
{
  expect_volume({{{0, 0, 0}, 1}, {{0, 5, 0}, 1}, {{0, 0, 0.2}, 0.5}}, 2 * ball);
}

// Neighbours overlap, the next but one just touch: only lenses of pairs are shared.
TEST(UnionVolume, ChainOfBalls)
{
  std::vector<Sphere> chain;
  for (int k = 0; k < 8; ++k) chain.push_back({{0.6 * k, 0, 0.8 * k}, 1});
  expect_volume(chain, 8 * ball - 7 * lens(1));
  RandomStream random(1);
  std::vector<Sphere> shuffled;
  for (const int k : random.permutation(8)) shuffled.push_back(chain[k]);
  EXPECT_NEAR(UnionVolume(shuffled).volume(), UnionVolume(chain).volume(), 1e-12);
}

TEST(UnionVolume, OnlyWithinTheBox)
{
  UnionVolume quarter(Eigen::AlignedBox3d(Vector3(0, 0, -1), Vector3(1, 1, 1)));
  EXPECT_EQ(quarter.volume(), 0);
  quarter.add({{0, 0, 0}, 1});
  EXPECT_NEAR(quarter.volume(), ball / 4, 1e-3 * ball);
}
} // namespace
