// A run, or a batch of clumps, that is told to stop. It takes another exit code than 130, a log
// that does not say why it ends, a half-written file that stays behind, or a clump without its
// exports, to fail.
#include "tests/stopped_run.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/wait.h>

using namespace stopped_run;

TEST(Interruption, EndsTheRunCleanly)
{
  const fs::path folder = fs::path(testing::TempDir()) / "interlock_interruption";
  fs::remove_all(folder);
  fs::create_directories(folder);
  // The log appears when the input has been accepted; then the filling goes on for minutes.
  const std::string command =
      "cd '" + folder.string() +
      "' && { '" INTERLOCK_PROGRAM "' run '" INTERLOCK_SOURCE_DIR "/cases/pullout/quick.prm'"
      " --set Stones/Count=2 --output run >out 2>err & } && pid=$!;"
      " for i in $(seq 1200); do [ -e run/used.prm ] && break; sleep 0.05; done;"
      " kill -TERM $pid; wait $pid";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);

  std::ostringstream log;
  log << std::ifstream(folder / "run" / "run.log").rdbuf();
  EXPECT_NE(log.str().find("Stopped: interrupted"), std::string::npos) << log.str();
  EXPECT_FALSE(fs::exists(folder / "run" / "summary.json"));
  for (const auto& entry : fs::directory_iterator(folder / "run"))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  fs::remove_all(folder);
}

TEST(Interruption, LeavesWholeClumps)
{
  const fs::path folder = fs::path(testing::TempDir()) / "interlock_interrupted_clumps";
  fs::remove_all(folder);
  fs::create_directories(folder);
  // 50 stones take many times longer than the first one, after which the signal comes.
  const std::string command =
      "cd '" + folder.string() +
      "' && '" INTERLOCK_PROGRAM "' stones --count 50 -o stones >/dev/null 2>&1;"
      " { '" INTERLOCK_PROGRAM "' clump stones --d-min 0.0005 --r-min 0.001 --density 2650"
      " --format mercury,liggghts -o clumps >out 2>err & } && pid=$!;"
      " for i in $(seq 1200); do [ -e clumps/stone_001.clump.json ] && break; sleep 0.02; done;"
      " kill -INT $pid; wait $pid";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);

  int clumps = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "clumps")) {
    const fs::path path = entry.path();
    EXPECT_NE(path.extension(), ".part") << path;
    if (path.extension() != ".json") continue;
    ++clumps;
    const std::string stem = (folder / "clumps" / path.stem().stem()).string();
    for (const char* file :
         {".multisphere", ".multisphere.in", ".mclump/readme.txt", ".mclump/Inertia/PD.txt"})
      EXPECT_TRUE(fs::exists(stem + file)) << stem + file;
  }
  EXPECT_GT(clumps, 0);
  EXPECT_LT(clumps, 50) << "the signal came too late to test anything";
  std::ostringstream out;
  out << std::ifstream(folder / "out").rdbuf();
  EXPECT_NE(out.str().find("Interrupted: "), std::string::npos) << out.str();
  fs::remove_all(folder);
}

// The program looks for its scripts beside where it is installed; here, one that never ends.
TEST_F(StoppedRunTest, WhileFiguresAreDrawnTheRunIsWhole)
{
  fs::create_directories(folder / "bin");
  fs::copy_file(program, folder / "bin" / "interlock");
  program = (folder / "bin" / "interlock").string();
  fs::create_directories(folder / "share" / "interlock" / "apps");
  std::ofstream(folder / "share" / "interlock" / "apps" / "figures.py")
      << "import pathlib, sys, time\n"
         "pathlib.Path(sys.argv[1], 'drawing').touch()\n"
         "time.sleep(3600)\n";
  Words words = pull_out("run");
  words.erase(std::remove(words.begin(), words.end(), "Output/Report=false"), words.end());
  words.erase(words.begin() + 1); // the --set of that
  const Ending ending =
      stop(SIGTERM, words, [this] { return fs::exists(folder / "run" / "drawing"); });
  EXPECT_EQ(ending.code, 130) << ending.err;
  EXPECT_NE(ending.err.find("the run is whole"), std::string::npos) << ending.err;
  EXPECT_NE(ending.err.find("interlock report run"), std::string::npos) << ending.err;
  EXPECT_TRUE(fs::exists(folder / "run" / "summary.json"));
}
