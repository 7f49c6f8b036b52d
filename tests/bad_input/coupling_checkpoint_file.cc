// Checkpoints that are not what was written. Fails when a file that is missing, foreign, cut off,
// of another format or changed in a single bit is taken for a state, crashes the reader or is
// answered with anything but one sentence that names it; when the one before is not offered; or
// when a write that fails leaves less than the old file, or more.
#include "coupling/files/atomic_file.h"
#include "coupling/state/checkpoint_file.h"
#include "dem/random_stream.h"
#include "tests/refusal.h"
#include "tests/small_disk.h"
#include "tests/temporary_folder.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
StateTree some_state(double first = 1)
{
  StateTree tree;
  tree["state/clock/step"] = {std::vector<std::int64_t>{4711}, 1};
  tree["state/engine/position"] = {std::vector<double>{first, 2, 3, 4, 5, 6}, 3, "m"};
  tree["state/stage"] = {std::vector<std::string>{"pull"}, 1};
  return tree;
}

std::string checksum(const std::string& bytes)
{
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

class CheckpointFile : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    file = folder / "checkpoint.h5";
  }

  // Bytes of a good file.
  std::string good_bytes() const
  {
    write_state(folder / "good.h5", some_state(), "1.2.3");
    return file_text(folder / "good.h5");
  }

  void put(const std::string& bytes) const { std::ofstream(file, std::ios::binary) << bytes; }

  // The bytes are refused with one sentence that holds `facts`.
  void expect_refused(const std::string& bytes, const std::vector<std::string>& facts) const
  {
    put(bytes);
    expect_refusal([&] { read_state(file); }, file.string(), facts);
  }

  std::size_t number_of_files() const
  {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  fs::path file;
};
} // namespace

TEST_F(CheckpointFile, IsNotThere)
{
  expect_refusal([&] { read_state(file); }, file.string(), {"is not there"});
  expect_refusal([&] { read_state(folder); }, folder.string(), {"is no file"});
  expect_refusal([&] { read_state(file / "below"); }, file.string(), {"is not there"});
}

TEST_F(CheckpointFile, IsEmptyOrForeign)
{
  expect_refused("", {"is empty"});
  expect_refused("I", {});
  const std::string foreign = "no state that this program has written";
  expect_refused("Interlock is a program.\n", {foreign});
  expect_refused(std::string(100000, '\0'), {foreign});
  // An HDF5 file of somebody else: the state without the block in front of it.
  expect_refused(good_bytes().substr(512), {foreign});
  // The end of a line changed on the way, as some programs do with text.
  std::string text = good_bytes();
  text.replace(text.find('\n'), 1, "\r\n");
  expect_refused(text, {foreign});
}

TEST_F(CheckpointFile, IsCutOffAnywhere)
{
  const std::string good = good_bytes();
  for (std::size_t length = 1; length < 600; ++length) expect_refused(good.substr(0, length), {});
  for (std::size_t length = 600; length < good.size(); length += 97)
    expect_refused(good.substr(0, length), {"is cut off", std::to_string(length)});
  expect_refused(good.substr(0, good.size() - 1), {"is cut off"});
}

TEST_F(CheckpointFile, IsLongerThanItWas)
{
  const std::string good = good_bytes();
  expect_refused(good + '\0', {"is longer"});
  expect_refused(good + good, {"is longer"});
}

// Every bit of the block at the head, and 2000 of all.
TEST_F(CheckpointFile, HasAChangedBit)
{
  const std::string good = good_bytes();
  interlock::dem::RandomStream random(20);
  const auto with_flip = [&](std::size_t bit) {
    std::string bytes = good;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    return bytes;
  };
  for (std::size_t bit = 0; bit < 8 * 512; ++bit) {
    expect_refused(with_flip(bit), {});
    ASSERT_FALSE(HasFailure()) << "bit " << bit;
  }
  for (int n = 0; n < 2000; ++n) {
    const std::size_t bit = random.index(static_cast<int>(8 * good.size()));
    expect_refused(with_flip(bit), {});
    ASSERT_FALSE(HasFailure()) << "bit " << bit;
  }
  expect_refused(with_flip(8 * good.size() - 1), {"is damaged", "checksum"});
}

// A hole that a file system left behind: a page of zeros.
TEST_F(CheckpointFile, HasAHole)
{
  std::string bytes = good_bytes();
  ASSERT_GT(bytes.size(), 1024u);
  bytes.replace(512, 512, 512, '\0');
  expect_refused(bytes, {"is damaged"});
}

// A whole file of an earlier or a later program, with checksums that are right.
TEST_F(CheckpointFile, HasAnotherFormat)
{
  const std::string good = good_bytes(), data = good.substr(512);
  const auto with_format = [&](const std::string& format) {
    std::string block =
        "Interlock state\n" + fmt::format("format {}\nprogram {}\nbytes {}\nxxh3-128 {}\n", format,
                                          "1.2.3", data.size(), checksum(data));
    block.resize(512 - 33, ' ');
    return block + checksum(block) + '\n' + data;
  };
  ASSERT_EQ(with_format(std::to_string(state_format)), good); // this is how blocks are made
  for (const int other : {0, state_format - 1, state_format + 1, 17}) {
    const std::string format = std::to_string(other);
    expect_refused(with_format(format),
                   {"the format " + format, "reads format " + std::to_string(state_format)});
  }
}

TEST_F(CheckpointFile, OffersTheOneBefore)
{
  write_checkpoint(file, some_state(1), "1.2.3");
  write_checkpoint(file, some_state(2), "1.2.3");
  const fs::path before = previous_of(file);
  EXPECT_EQ(before, folder / "checkpoint.previous.h5");
  EXPECT_EQ(first_difference(read_state(file), some_state(2)), std::nullopt);
  EXPECT_EQ(first_difference(read_state(before), some_state(1)), std::nullopt);

  const std::string good = file_text(file);
  const std::string offer = "\"" + before.string() + "\", is good";
  expect_refused(good.substr(0, good.size() / 2), {"is cut off", offer});
  expect_refused("", {offer});
  fs::remove(file);
  expect_refusal([&] { read_state(file); }, file.string(), {"is not there", offer});

  // But not when it is damaged, too.
  std::string damaged = file_text(before);
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  std::ofstream(before, std::ios::binary) << damaged;
  try {
    read_state(file);
    ADD_FAILURE();
  } catch (const interlock::InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("previous"), std::string::npos) << error.what();
  }
}

// --- Writes that fail --------------------------------------------------------------------------

TEST_F(CheckpointFile, FullDiskLeavesTheOldOne)
{
  write_checkpoint(file, some_state(1), "1.2.3");
  write_checkpoint(file, some_state(2), "1.2.3");
  const std::string now = file_text(file), before = file_text(previous_of(file));
  for (const std::size_t room : {0, 100, 512, 1500}) {
    ASSERT_LT(room, now.size());
    try {
      const SmallDisk disk(room);
      write_checkpoint(file, some_state(3), "1.2.3");
      ADD_FAILURE() << "written with room for " << room << " bytes";
    } catch (const WriteError& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(file.string()), std::string::npos) << text;
      EXPECT_NE(text.find("File too large"), std::string::npos) << text; // EFBIG: the reason
    }
    EXPECT_EQ(file_text(file), now);
    EXPECT_EQ(file_text(previous_of(file)), before);
    EXPECT_EQ(number_of_files(), 2u); // and no temporary one
  }
  write_checkpoint(file, some_state(3), "1.2.3");
  EXPECT_EQ(first_difference(read_state(file), some_state(3)), std::nullopt);
  EXPECT_EQ(file_text(previous_of(file)), now);
}

TEST_F(CheckpointFile, FolderThatIsGone)
{
  try {
    write_checkpoint(folder / "gone" / "checkpoint.h5", some_state(), "1.2.3");
    ADD_FAILURE();
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos);
  }
  EXPECT_EQ(number_of_files(), 0u);
}
