// Clumps that are no good stand-in. Fails when one in pieces or with too little volume goes without
// a warning, when the warning names a setting that is not in the way, or when a good clump gets
// one.
#include "apps/clump_warnings.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace
{
using namespace interlock;

apps::ClumpResult clump(int groups, double volume_error, dem::Stop stop)
{
  apps::ClumpResult result;
  result.name = "a";
  result.facets = 8;
  result.report.groups = groups;
  result.report.volume_error = volume_error;
  result.report.stop = stop;
  result.shape.spheres = {{dem::Vector3::Zero(), 0.01}};
  result.parameters.d_min = result.parameters.r_min = 1e-3;
  return result;
}

void expect_words(const std::string& text, const std::vector<std::string>& words)
{
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(ClumpWarnings, GoodClumpsHaveNone)
{
  EXPECT_EQ(apps::clump_warnings(clump(1, -0.09, dem::Stop::all_nodes)), "");
  EXPECT_EQ(apps::clump_warnings(clump(1, 0.09, dem::Stop::p_max)), "");
  EXPECT_EQ(apps::clump_warnings(clump(1, -0.3, dem::Stop::volume_error)), ""); // as asked
}

TEST(ClumpWarnings, Groups)
{
  expect_words(apps::clump_warnings(clump(3, 0, dem::Stop::max_spheres)),
               {"'a' are in 3 groups", "larger --max-spheres, or --sphere-order gain.\n"});
  expect_words(apps::clump_warnings(clump(2, 0, dem::Stop::p_max)), {"larger --p-max."});
  expect_words(apps::clump_warnings(clump(2, 0, dem::Stop::all_nodes)),
               {"choose a smaller --d-min or a larger --r-min."});
  auto apart = clump(2, 0, dem::Stop::all_nodes);
  apart.parameters.d_min = 4e-3;
  expect_words(apps::clump_warnings(apart), {"choose --d-min not above --r-min."});
  EXPECT_EQ(apps::clump_json(apart)["groups"], 2);
}

TEST(ClumpWarnings, Volume)
{
  expect_words(apps::clump_warnings(clump(1, -0.23, dem::Stop::all_nodes)),
               {"23 % less volume than the stone", "smaller --d-min"});
  auto rejected = clump(1, -0.23, dem::Stop::all_nodes);
  rejected.report.rejected = 5;
  rejected.parameters.d_min = 0;
  expect_words(apps::clump_warnings(rejected), {"smaller --r-min."});
  auto nodes = clump(1, 0.4, dem::Stop::all_nodes);
  nodes.parameters.touching_radius = dem::TouchingRadius::nodes;
  expect_words(apps::clump_warnings(nodes), {"40 % more", "--touching-radius surface"});
}

TEST(ClumpWarnings, NotesOfTheReaderAreRemarks)
{
  auto noted = clump(1, 0, dem::Stop::all_nodes);
  noted.mesh.notes = {"12 bytes behind its last facet were left out"};
  EXPECT_EQ(apps::remarks(noted), "  'a': 12 bytes behind its last facet were left out.\n");
  EXPECT_EQ(apps::clump_json(noted)["diagnosis"]["notes"].size(), 1u);
}
} // namespace
