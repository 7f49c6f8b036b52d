// What is said of a stone beside its numbers. Fails when noise that makes the volume 1 % too large,
// or a form whose axes are left open, goes without a sentence, or when a quiet stone gets one.
#include "apps/clump_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace
{
using namespace interlock;

apps::ClumpResult noisy_cloud(double scatter_over_spacing)
{
  apps::ClumpResult result;
  result.name = "cloud";
  result.cloud.spacing = 1e-3;
  result.cloud.scatter = scatter_over_spacing * 1e-3;
  result.cloud.volume_excess = 2.5 * scatter_over_spacing * scatter_over_spacing;
  result.shape.spheres = {{dem::Vector3::Zero(), 0.01}};
  return result;
}

TEST(ClumpTable, NoiseOfACloud)
{
  EXPECT_EQ(apps::remarks(noisy_cloud(0.05)), "");
  const std::string text = apps::remarks(noisy_cloud(0.1));
  EXPECT_NE(text.find("0.1 mm along their normals, 10.0 % of their spacing"), std::string::npos)
      << text;
  EXPECT_NE(text.find("too large by about 2.5 %"), std::string::npos) << text;
  const auto json = apps::clump_json(noisy_cloud(0.1));
  EXPECT_DOUBLE_EQ(json["diagnosis"]["scatter_m"], 1e-4);
  EXPECT_DOUBLE_EQ(json["diagnosis"]["scatter_over_spacing"], 0.1);
}

TEST(ClumpTable, OpenAxes)
{
  apps::ClumpResult result = noisy_cloud(0);
  result.report.axes_are_distinct = false;
  EXPECT_NE(apps::remarks(result).find("depend on how the file is turned"), std::string::npos);
  EXPECT_EQ(apps::clump_json(result)["axes_are_distinct"], false);
}

TEST(ClumpTable, BodyFrame)
{
  apps::ClumpResult result = noisy_cloud(0);
  result.report.origin = dem::Vector3(1, 2, 3);
  result.report.rotation = dem::Quaternion(0.5, 0.5, -0.5, 0.5);
  const auto frame = apps::clump_json(result)["body_frame"];
  EXPECT_EQ(frame["origin_m"], nlohmann::ordered_json({1., 2., 3.}));
  EXPECT_EQ(frame["rotation_w_x_y_z"], nlohmann::ordered_json({0.5, 0.5, -0.5, 0.5}));
}
} // namespace
