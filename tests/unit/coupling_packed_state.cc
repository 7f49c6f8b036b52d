// States of packed boxes in files. It takes a digit that is lost on the way to a file and back,
// compressed or not, a benchmark state that is not read whole, or a squeeze that changes stones, to
// fail.
#include "coupling/files/compressed_file.h"
#include "coupling/packing/packed_state.h"
#include "tests/packed_plates.h"
#include "tests/temporary_folder.h"

using namespace interlock;
using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
using PackedStateFile = TemporaryFolderTest;

PackedState odd_state()
{
  PackedState state = packed_plates(3);
  state.box *= 1. / 3 * 3.1;
  state.clumps[1].orientation = dem::Quaternion(1, 0.1, -0.2, 1. / 3).normalized();
  state.clumps[1].velocity = {0.1, -1e-17, 1. / 7};
  state.clumps[2].spin = {1e5, 2. / 3, -3};
  return state;
}

void expect_same(const PackedState& a, const PackedState& b)
{
  EXPECT_EQ(a.box, b.box);
  EXPECT_EQ(a.density, b.density);
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t s = 0; s < a.shapes.size(); ++s) {
    EXPECT_EQ(a.shapes[s].volume, b.shapes[s].volume);
    EXPECT_LT((a.shapes[s].unit_inertia - b.shapes[s].unit_inertia).norm(),
              1e-15 * a.shapes[s].unit_inertia.norm()); // density times, then divided by
    ASSERT_EQ(a.shapes[s].spheres.size(), b.shapes[s].spheres.size());
    for (std::size_t k = 0; k < a.shapes[s].spheres.size(); ++k) {
      EXPECT_EQ(a.shapes[s].spheres[k].centre, b.shapes[s].spheres[k].centre);
      EXPECT_EQ(a.shapes[s].spheres[k].radius, b.shapes[s].spheres[k].radius);
    }
  }
  ASSERT_EQ(a.clumps.size(), b.clumps.size());
  for (std::size_t k = 0; k < a.clumps.size(); ++k) {
    EXPECT_EQ(a.clumps[k].shape, b.clumps[k].shape);
    EXPECT_EQ(a.clumps[k].position, b.clumps[k].position);
    EXPECT_LT((a.clumps[k].orientation.coeffs() - b.clumps[k].orientation.coeffs()).norm(), 3e-16);
    EXPECT_EQ(a.clumps[k].velocity, b.clumps[k].velocity);
    EXPECT_EQ(a.clumps[k].spin, b.clumps[k].spin);
  }
}
} // namespace

TEST_F(PackedStateFile, IsReadAsItWasWritten)
{
  const PackedState state = odd_state();
  for (const char* name : {"state.json", "state.json.gz"}) {
    write_packed_state(folder / name, state);
    expect_same(read_packed_state(folder / name), state);
  }
  EXPECT_LT(fs::file_size(folder / "state.json.gz"), fs::file_size(folder / "state.json"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

// An archive that was unpacked, or packed, without a change of its name.
TEST_F(PackedStateFile, CompressionIsSeenInTheFileNotInItsName)
{
  write_packed_state(folder / "state.json.gz", odd_state());
  fs::rename(folder / "state.json.gz", folder / "state.json");
  EXPECT_EQ(read_packed_state(folder / "state.json").clumps.size(), 3u);
}

TEST_F(PackedStateFile, LongTextsComeBackFromCompression)
{
  std::string text;
  for (int k = 0; k < 300000; ++k) text += std::to_string(k % 10007 * 7919);
  write_maybe_compressed(folder / "long.gz", text);
  EXPECT_EQ(read_maybe_compressed(folder / "long.gz"), text);
}

// Numbers of cases/benchmark/README.md.
TEST_F(PackedStateFile, BenchmarkStatesAreWhole)
{
  const fs::path cases = fs::path(INTERLOCK_SOURCE_DIR) / "cases" / "benchmark";
  const PackedState w1 = read_packed_state(cases / "w1_settled.json.gz");
  EXPECT_EQ(w1.clumps.size(), 410u);
  EXPECT_EQ(w1.shapes.size(), 10u);
  for (const dem::ClumpShape& shape : w1.shapes) EXPECT_EQ(shape.spheres.size(), 55u);
  EXPECT_EQ(w1.density, 2700);
  EXPECT_EQ(w1.box.x(), 0.4);
  EXPECT_EQ(w1.box.y(), 0.3);
  EXPECT_EQ(read_packed_state(cases / "w2_settled.json.gz").clumps.size(), 1640u);
}

TEST(Squeeze, MovesStonesTogetherAndLeavesThemAsTheyAre)
{
  const PackedState before = odd_state();
  PackedState after = before;
  squeeze(after, 0.01);
  EXPECT_NEAR((after.box - 0.99 * before.box).norm(), 0, 1e-16);
  for (std::size_t k = 0; k < before.clumps.size(); ++k)
    EXPECT_NEAR((after.clumps[k].position - 0.99 * before.clumps[k].position).norm(), 0, 1e-16);
  EXPECT_EQ(after.shapes[0].spheres[0].radius, before.shapes[0].spheres[0].radius);
  EXPECT_EQ(after.clumps[1].orientation.coeffs(), before.clumps[1].orientation.coeffs());
}
