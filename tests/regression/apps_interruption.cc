// A run that is told to stop. It takes another exit code than 130, a log that does not say why it
// ends, or a half-written file that stays behind, to fail.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/wait.h>

namespace fs = std::filesystem;

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
