// A clump shape survives its file to the last digit. Fails when a number is rounded, when spheres
// change order, or when a temporary file stays behind.
#include "dem/bodies/clump_shape.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
using namespace interlock::dem;
namespace fs = std::filesystem;

TEST(ClumpShape, ComesBackToTheSameDigits)
{
  ClumpShape shape;
  shape.name = "stone \"7\"";
  shape.volume = 1e-5 / 3;
  shape.unit_inertia = Vector3(1e-10 / 3, 1e-10 / 7, 1e-10 / 11);
  shape.spheres = {{{1. / 3, -1e-17, 0.1}, 0.2}, {{0, 1. / 7, -2}, 1e-3 / 9}};
  const std::string path = (fs::path(testing::TempDir()) / "interlock_shape.clump.json").string();
  write_clump_shape(path, shape);
  EXPECT_FALSE(fs::exists(path + ".tmp"));
  const ClumpShape copy = read_clump_shape(path);
  EXPECT_EQ(copy.name, shape.name);
  EXPECT_EQ(copy.volume, shape.volume);
  EXPECT_EQ(copy.unit_inertia, shape.unit_inertia);
  ASSERT_EQ(copy.spheres.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(copy.spheres[i].centre, shape.spheres[i].centre);
    EXPECT_EQ(copy.spheres[i].radius, shape.spheres[i].radius);
  }
}

TEST(ClumpShape, BoundingRadius)
{
  ClumpShape shape;
  EXPECT_EQ(shape.bounding_radius(), 0);
  shape.spheres = {{{0, 0, 0}, 2}, {{3, 4, 0}, 1}};
  EXPECT_DOUBLE_EQ(shape.bounding_radius(), 6);
}
} // namespace
