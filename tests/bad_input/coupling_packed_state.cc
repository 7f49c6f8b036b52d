// States of packed boxes that cannot be used. Each test states one fault and the words that must be
// in the one sentence that answers it: file, entry, value and what is allowed. It takes a fault
// that is accepted, or a sentence that does not say where it is, to fail.
#include "coupling/files/compressed_file.h"
#include "coupling/packing/packed_state.h"
#include "tests/packed_plates.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <sstream>

using namespace interlock;
using namespace interlock::coupling;
namespace fs = std::filesystem;
using nlohmann::json;

namespace
{
class BadPackedState : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write_packed_state(folder / "good.json", packed_plates(2));
    good = json::parse(std::ifstream(folder / "good.json"));
  }

  void expect_bad_file(const std::string& name, const std::vector<std::string>& words) const
  {
    expect_refusal([&] { read_packed_state(folder / name); }, name, words);
  }

  // The value at `place` (a JSON pointer) becomes `value`.
  void expect_bad_value(const std::string& place, const json& value,
                        const std::vector<std::string>& words) const
  {
    json bad = good;
    bad[json::json_pointer(place)] = value;
    write("bad.json", bad.dump());
    expect_bad_file("bad.json", words);
  }

  // The entry `name` of the object at `place` is missing.
  void expect_missing(const std::string& place, const std::string& name,
                      const std::string& word) const
  {
    json bad = good;
    bad[json::json_pointer(place)].erase(name);
    write("bad.json", bad.dump());
    expect_bad_file("bad.json", {"no entry \"" + word + "\"", "there is: "});
  }

  json good;
};
} // namespace

TEST_F(BadPackedState, FilesThatCannotBeRead)
{
  expect_bad_file("none.json", {"cannot be read"});
  expect_refusal([&] { read_packed_state(folder); }, folder.filename().string(),
                 {"cannot be read"});
  write("text.json", "{\"format\": ");
  expect_bad_file("text.json", {"is not JSON", "byte 12"});
  write("empty.json", "");
  expect_bad_file("empty.json", {"is not JSON"});
  write("list.json", "[1, 2]");
  expect_bad_file("list.json", {"no"});
}

TEST_F(BadPackedState, BrokenArchives)
{
  write_packed_state(folder / "good.json.gz", packed_plates(2));
  std::ostringstream bytes;
  bytes << std::ifstream(folder / "good.json.gz", std::ios::binary).rdbuf();
  const std::string whole = bytes.str();
  write("cut.json.gz", whole.substr(0, whole.size() / 2));
  expect_bad_file("cut.json.gz", {"damaged or cut off"});
  write("short.json.gz", whole.substr(0, whole.size() - 4)); // its last four bytes are its length
  expect_bad_file("short.json.gz", {"damaged or cut off"});
  std::string damaged = whole;
  damaged[whole.size() / 2] ^= 0x55;
  write("damaged.json.gz", damaged);
  expect_bad_file("damaged.json.gz", {"damaged or cut off"});
}

TEST_F(BadPackedState, AnotherFormat)
{
  expect_bad_value("/format", "clump-workload-2",
                   {"format = \"clump-workload-2\"", "\"clump-workload-1\""});
  expect_missing("", "format", "format");
}

TEST_F(BadPackedState, MissingEntries)
{
  for (const char* name : {"box", "density", "shapes", "clumps"}) expect_missing("", name, name);
  for (const char* name : {"mass", "volume", "inertia", "spheres"})
    expect_missing("/shapes/0", name, std::string("shapes[0]/") + name);
  for (const char* name : {"shape", "pos", "quat", "vel", "omega"})
    expect_missing("/clumps/1", name, std::string("clumps[1]/") + name);
}

TEST_F(BadPackedState, NumbersThatAreNone)
{
  std::string text = good.dump();
  text.replace(text.find("2500"), 4, "NaN");
  write("nan.json", text);
  expect_bad_file("nan.json", {"is not JSON"});
  text = good.dump();
  text.replace(text.find("2500"), 6, "1e999");
  write("huge.json", text);
  expect_bad_file("huge.json", {"too large"});
  expect_bad_value("/density", "heavy", {"density = \"heavy\"", "a number"});
  expect_bad_value("/density", -2700, {"density = -2700", "greater than 0"});
  expect_bad_value("/clumps/0/pos", {0.01, 0.02, nullptr}, {"clumps[0]/pos", "null", "3 numbers"});
  expect_bad_value("/clumps/0/vel", {0.01, 0.02}, {"clumps[0]/vel", "3 numbers"});
}

TEST_F(BadPackedState, Shapes)
{
  expect_bad_value("/shapes", json::array(), {"shapes = []", "one element or more"});
  expect_bad_value("/shapes/0", 5, {"shapes[0] = 5", "named entries"});
  expect_bad_value("/shapes/0/spheres", json::array(), {"shapes[0]/spheres", "one sphere or more"});
  expect_bad_value("/shapes/0/spheres/2", {0, 0, 0, -0.01},
                   {"shapes[0]/spheres[2] = [0,0,0,-0.01]", "radius greater than 0"});
  expect_bad_value("/shapes/0/spheres/2", {0, 0, 0.01}, {"shapes[0]/spheres[2]", "4 numbers"});
  // 1.4e-5 m3 of 2500 kg/m3 are 35 g.
  expect_bad_value("/shapes/0/mass", 0.07,
                   {"shapes[0]/mass = 0.07", "0.035", "density times volume"});
  expect_bad_value("/shapes/0/inertia", {1e-6, 1e-6, 3e-6},
                   {"shapes[0]/inertia", "none is larger than the sum of the other two"});
}

TEST_F(BadPackedState, Clumps)
{
  for (const json& shape : {json(1), json(-1), json(0.5), json("plate")})
    expect_bad_value("/clumps/1/shape", shape,
                     {"clumps[1]/shape = " + shape.dump(), "from 0 to 0"});
  expect_bad_value("/clumps/1/quat", {1, 0, 0, 0.1}, {"clumps[1]/quat", "length 1"});
  expect_bad_value("/clumps/1/quat", {0, 0, 0, 0}, {"clumps[1]/quat", "length 1"});
  expect_bad_value("/clumps/1/pos", {0.03, 0.06, 0.02}, {"clumps[1]/pos", "between the walls"});
  expect_bad_value("/clumps/1/pos", {0.03, 0.02, -0.02}, {"clumps[1]/pos", "above the floor"});
}
