// A state on disk. Fails when a bit, a shape, a unit or an empty list is lost in the file, when the
// one before is not kept, or when h5py cannot open what docs/checkpoint_format.md says it opens.
#include "coupling/state/checkpoint_file.h"
#include "tests/temporary_folder.h"

#include <cstdlib>
#include <cstring>
#include <limits>

using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
double from_bits(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

StateTree any_state()
{
  using Whole = std::numeric_limits<std::int64_t>;
  StateTree tree;
  tree["state/engine/position"] = {
      std::vector<double>{0.1, -0., 1e-310, from_bits(0x7ff8000000abcdefu),
                          std::numeric_limits<double>::infinity(), 1. / 3},
      3, "m"};
  tree["state/engine/mass"] = {std::vector<double>{2.5}, 1, "kg"};
  tree["state/engine/none"] = {std::vector<double>(), 1, "N"};
  tree["state/engine/no_rows"] = {std::vector<double>(), 3, "N m"};
  tree["state/engine/id"] = {std::vector<std::int64_t>{Whole::min(), 0, Whole::max()}, 1};
  tree["state/engine/no_ids"] = {std::vector<std::int64_t>(), 1};
  tree["state/words"] = {std::vector<std::string>{"", "pull",
                                                  "Korngr\xc3\xb6\xc3\x9f"
                                                  "e\n",
                                                  std::string(70000, 'x')},
                         1};
  tree["state/no_words"] = {std::vector<std::string>(), 1};
  tree["case/Pull/Displacement"] = {std::vector<std::string>{"0.05"}, 1};
  return tree;
}

class CheckpointFile : public TemporaryFolderTest
{
};
} // namespace

TEST_F(CheckpointFile, KeepsEveryBit)
{
  const StateTree tree = any_state();
  write_state(folder / "state.h5", tree, "1.2.3");
  const StateTree read = read_state(folder / "state.h5");
  EXPECT_EQ(first_difference(read, tree), std::nullopt);
  EXPECT_EQ(hash_of(read), hash_of(tree));
  for (const auto& [path, array] : tree) {
    ASSERT_EQ(read.count(path), 1u) << path;
    EXPECT_EQ(read.at(path).unit, array.unit) << path;
    EXPECT_EQ(read.at(path).columns, array.columns) << path;
  }
}

TEST_F(CheckpointFile, KeepsAStateWithNothingInIt)
{
  write_state(folder / "state.h5", {}, "1.2.3");
  EXPECT_TRUE(read_state(folder / "state.h5").empty());
}

TEST_F(CheckpointFile, SavedAgainItIsTheSameFile)
{
  write_state(folder / "a.h5", any_state(), "1.2.3");
  write_state(folder / "b.h5", read_state(folder / "a.h5"), "1.2.3");
  EXPECT_EQ(file_text(folder / "a.h5"), file_text(folder / "b.h5"));
}

TEST_F(CheckpointFile, KeepsTheOneBeforeAndNoMore)
{
  const fs::path file = folder / "checkpoint.h5";
  for (double k : {1, 2, 3}) {
    StateTree tree = any_state();
    tree["state/engine/mass"].values = std::vector<double>{k};
    write_checkpoint(file, tree, "1.2.3");
    EXPECT_EQ(first_difference(read_state(file), tree), std::nullopt);
    EXPECT_EQ(fs::exists(previous_of(file)), k > 1);
    if (k > 1) {
      tree["state/engine/mass"].values = std::vector<double>{k - 1};
      EXPECT_EQ(first_difference(read_state(previous_of(file)), tree), std::nullopt);
    }
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

// The head is text for people: who wrote it, and what the file is.
TEST_F(CheckpointFile, BeginsWithABlockOfText)
{
  write_state(folder / "state.h5", any_state(), "1.2.3-dev");
  const std::string text = file_text(folder / "state.h5");
  EXPECT_EQ(text.find("Interlock state\nformat " + std::to_string(state_format) +
                      "\nprogram 1.2.3-dev\nbytes " + std::to_string(text.size() - 512) +
                      "\nxxh3-128 "),
            0u);
  EXPECT_EQ(text[511], '\n');
  EXPECT_EQ(text.substr(512, 4), "\x89HDF");
}

TEST_F(CheckpointFile, OpensInH5py)
{
  if (std::system("/usr/bin/python3 -c 'import h5py, numpy' 2> /dev/null") != 0)
    GTEST_SKIP() << "there is no h5py";
  write_state(folder / "state.h5", any_state(), "1.2.3");
  const fs::path script = write("look.py", R"(
import sys
import h5py
import numpy as np

with h5py.File(sys.argv[1], "r") as file:
    position = file["state/engine/position"]
    assert position.shape == (2, 3) and position.dtype == np.float64, position
    assert position.attrs["unit"] == "m"
    bits = position[:].view(np.uint64).ravel()
    assert bits[3] == 0x7ff8000000abcdef and bits[1] == 1 << 63, bits
    assert file["state/engine/no_rows"].shape == (0, 3)
    identity = file["state/engine/id"]
    assert identity.dtype == np.int64 and "unit" not in identity.attrs
    assert identity[0] == -2**63 and identity[2] == 2**63 - 1
    words = file["state/words"].asstr()[:]
    assert words[0] == "" and words[1] == "pull" and words[2] == "Korngr\u00f6\u00dfe\n", words
    assert file["case/Pull/Displacement"].asstr()[0] == "0.05"
    assert sorted(file) == ["case", "state"]
)");
  const std::string command =
      "/usr/bin/python3 '" + script.string() + "' '" + (folder / "state.h5").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
}
