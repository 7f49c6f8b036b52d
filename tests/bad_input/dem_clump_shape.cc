// Every fault of a clump file is an InputError that names the file, the entry and its value. Fails
// when a fault passes or an exception of the JSON library escapes.
#include "dem/bodies/clump_shape.h"
#include "dem/input_error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
using namespace interlock::dem;
namespace fs = std::filesystem;

void expect_refusal(const std::string& content, const std::vector<std::string>& facts)
{
  const std::string path = (fs::path(testing::TempDir()) / "interlock_bad.clump.json").string();
  std::ofstream(path) << content;
  try {
    read_clump_shape(path);
    FAIL() << content << " was accepted";
  } catch (const interlock::InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(path), std::string::npos) << text;
    for (const std::string& fact : facts) EXPECT_NE(text.find(fact), std::string::npos) << text;
  }
}

std::string clump(const std::string& volume, const std::string& inertia, const std::string& spheres)
{
  return R"({"format": "interlock clump 1", "name": "a", "volume_m3": )" + volume +
         R"(, "unit_inertia_m5": )" + inertia + R"(, "spheres_x_y_z_r_m": )" + spheres + "}";
}

TEST(ClumpFile, Missing)
{
  EXPECT_THROW(read_clump_shape("/nowhere/a.clump.json"), interlock::InputError);
  EXPECT_THROW(write_clump_shape("/nowhere/a.clump.json", ClumpShape()), interlock::InputError);
}

TEST(ClumpFile, NotJson)
{
  expect_refusal("", {"not JSON"});
  expect_refusal("{\"format\": ", {"not JSON"});
  expect_refusal("[1, 2]", {"JSON object"});
}

TEST(ClumpFile, Entries)
{
  const std::string good = "[1e-9, 1e-9, 1e-9]", one = "[[0, 0, 0, 0.01]]";
  expect_refusal("{\"name\": \"a\"}", {"no entry 'format'", "name"});
  expect_refusal("{\"format\": \"other\"}", {"\"other\"", "interlock clump 1"});
  expect_refusal(clump("-1", good, one), {"volume_m3", "-1", "above 0"});
  expect_refusal(clump("\"1\"", good, one), {"volume_m3"});
  expect_refusal(clump("1", "[1, 2]", one), {"unit_inertia_m5", "[1,2]", "3 numbers"});
  expect_refusal(clump("1", "[1, 0, 1]", one), {"unit_inertia_m5[1]", "above 0"});
  expect_refusal(clump("1", good, "[]"), {"no sphere"});
  expect_refusal(clump("1", good, "[[0, 0, 0, 1], [0, 0, 0]]"), {"spheres_x_y_z_r_m[1]"});
  expect_refusal(clump("1", good, "[[0, 0, 0, -1]]"), {"spheres_x_y_z_r_m[0][3]", "-1"});
}
} // namespace
