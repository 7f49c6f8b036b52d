// Who may write into an output folder. It takes results that are written over unasked, files of two
// runs side by side, two runs at a time in one folder, or a file of the user that is removed, to
// fail.
#include "tests/temporary_folder.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
class RunFolder : public TemporaryFolderTest
{
protected:
  // A test of the laboratory that takes a moment.
  int run(const std::string& options)
  {
    const std::string command = "cd '" + folder.string() +
                                "' && '" INTERLOCK_PROGRAM "' run '" INTERLOCK_SOURCE_DIR
                                "/cases/geogrids/bx1100.prm'"
                                " --set 'Laboratory/Test=single-rib tension' --set "
                                "Laboratory/Steps=2 --set Output/Report=false --output run " +
                                options + " >out 2>err";
    const int status = std::system(command.c_str());
    err = file_text(folder / "err");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path in_run(const std::string& name) const { return folder / "run" / name; }

  std::string err;
};
} // namespace

TEST_F(RunFolder, KeepsAFinishedRunUntilToldOtherwise)
{
  ASSERT_EQ(run(""), 0) << err;
  const std::string summary = file_text(in_run("summary.json")),
                    used = file_text(in_run("used.prm"));
  EXPECT_EQ(run("--set Product/Density=930"), 2);
  EXPECT_NE(err.find("holds a finished run; --force"), std::string::npos) << err;
  EXPECT_EQ(file_text(in_run("summary.json")), summary);
  EXPECT_EQ(file_text(in_run("used.prm")), used);
  EXPECT_EQ(run("--set Product/Density=930 --force"), 0) << err;
  EXPECT_NE(file_text(in_run("used.prm")).find("set Density = 930"), std::string::npos);
}

// What the new run does not write itself must not stay from the old one; what no run writes, stays.
TEST_F(RunFolder, ForceLeavesNothingOfTheRunBefore)
{
  ASSERT_EQ(run(""), 0) << err;
  fs::create_directories(in_run("figures"));
  fs::create_directories(in_run("frames"));
  for (const char* name :
       {"state_before_pull.h5", "checkpoint.h5", "stones.csv", "profile.csv", "figures/old.png",
        "frames/clumps_000000.vtkhdf", "clumps.xdmf", "clumps.h5", "notes.txt", "measured.h5"})
    std::ofstream(in_run(name)) << "old";
  ASSERT_EQ(run("--force"), 0) << err;
  for (const char* name :
       {"state_before_pull.h5", "checkpoint.h5", "stones.csv", "profile.csv", "figures/old.png",
        "frames/clumps_000000.vtkhdf", "clumps.xdmf", "clumps.h5"})
    EXPECT_FALSE(fs::exists(in_run(name))) << name;
  for (const char* name : {"notes.txt", "measured.h5"})
    EXPECT_EQ(file_text(in_run(name)), "old") << name;
}

TEST_F(RunFolder, KeepsAStoppedRun)
{
  fs::create_directories(folder / "run");
  std::ofstream(in_run("checkpoint.h5")) << "state";
  EXPECT_EQ(run(""), 2);
  EXPECT_NE(err.find("--resume"), std::string::npos) << err;
  EXPECT_EQ(file_text(in_run("checkpoint.h5")), "state");
}

TEST_F(RunFolder, BelongsToOneRunAtATime)
{
  fs::create_directories(folder / "run");
  std::ofstream(in_run("run.log")) << "of the other run\n";
  const int other = open(in_run("run.log").c_str(), O_RDWR);
  ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(run("--force"), 2);
  EXPECT_NE(err.find("is in use"), std::string::npos) << err;
  EXPECT_EQ(file_text(in_run("run.log")), "of the other run\n");
  EXPECT_FALSE(fs::exists(in_run("used.prm")));
  close(other); // as when that run ends
  EXPECT_EQ(run("--force"), 0) << err;
}
