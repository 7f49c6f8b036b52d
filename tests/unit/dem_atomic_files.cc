// Files that belong together appear together. Fails when a write that cannot be finished changes
// an old file, leaves a temporary one, or lets a part of a new folder be seen.
#include "dem/atomic_files.h"
#include "dem/input_error.h"
#include "dem/stones/synthetic_stone.h"
#include "tests/temporary_folder.h"

#include <csignal>
#include <sstream>

#include <sys/resource.h>

namespace
{
namespace fs = std::filesystem;
using interlock::dem::write_atomically;

class AtomicFiles : public TemporaryFolderTest
{
protected:
  std::string text_of(const fs::path& name) const
  {
    std::ostringstream text;
    text << std::ifstream(folder / name).rdbuf();
    return text.str();
  }

  int number_of_files() const
  {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.exists();
    return count;
  }
};

TEST_F(AtomicFiles, FilesAndNewFolders)
{
  write("a.txt", "old");
  EXPECT_FALSE(write_atomically(
      {{folder / "a.txt", "a"}, {folder / "d/x/b.txt", "b"}, {folder / "d/c.txt", "c"}}));
  EXPECT_EQ(text_of("a.txt") + text_of("d/x/b.txt") + text_of("d/c.txt"), "abc");
  EXPECT_EQ(number_of_files(), 5);
  EXPECT_FALSE(write_atomically({{folder / "d/x/b.txt", "again"}}));
  EXPECT_EQ(text_of("d/x/b.txt"), "again");
}

TEST_F(AtomicFiles, AllOrNone)
{
  write("a.txt", "old");
  fs::create_directory(folder / "in_the_way");
  const auto failed = write_atomically(
      {{folder / "a.txt", "new"}, {folder / "d/b.txt", "b"}, {folder / "in_the_way", "c"}});
  ASSERT_TRUE(failed);
  EXPECT_EQ(*failed, folder / "in_the_way");
  EXPECT_EQ(text_of("a.txt"), "old");
  EXPECT_EQ(number_of_files(), 2);
}

TEST_F(AtomicFiles, OneFileNeedsItsFolder)
{
  EXPECT_FALSE(write_atomically(folder / "no/a.txt", "a"));
  EXPECT_FALSE(write_atomically(folder, "a"));
  EXPECT_TRUE(write_atomically(folder / "a.txt", "a"));
  EXPECT_EQ(number_of_files(), 1);
}

// A limit of the size of files stands for a full disk.
TEST_F(AtomicFiles, FullDiskLeavesNothing)
{
  const auto mesh = interlock::dem::make_stones(1, 1)[0];
  rlimit old;
  getrlimit(RLIMIT_FSIZE, &old);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const auto failed =
      write_atomically({{folder / "a.txt", "a"}, {folder / "d/b.txt", std::string(5000, 'b')}});
  EXPECT_THROW(interlock::dem::write_stl((folder / "a.stl").string(), mesh), interlock::InputError);
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  ASSERT_TRUE(failed);
  EXPECT_EQ(*failed, folder / "d/b.txt");
  EXPECT_EQ(number_of_files(), 0);
}
} // namespace
