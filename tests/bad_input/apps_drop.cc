// Folders that `interlock drop` has nothing to draw from. It takes more than one sentence, another
// exit code than 2, or a file that is written, to fail.
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>

#include <sys/wait.h>

namespace fs = std::filesystem;

namespace
{
class Drop : public TemporaryFolderTest
{
protected:
  // A finished pull of 3 mm whose force rises to 100 N and drops to 40 N.
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    run_folder = folder / "run";
    put("used.prm", "include " INTERLOCK_SOURCE_DIR "/tests/regression/tiny_pull_out.prm\n");
    put("summary.json", "{\"results\": {}}\n");
    put_history([](double u) { return u < 1.5e-3 ? 5e4 * u : 40; });
    put("state_before_pull.h5", "not read");
  }

  void put(const std::string& name, const std::string& text) const
  {
    fs::create_directories(run_folder);
    std::ofstream(run_folder / name) << text;
  }

  void put_history(const std::function<double(double)>& force, int rows = 31) const
  {
    std::string text = "time [s],displacement [m],pull_force [N]\n";
    for (int k = 0; k < rows; ++k) {
      const double u = rows > 1 ? 3e-3 * k / (rows - 1) : 0;
      text += std::to_string(k) + "," + std::to_string(u) + "," + std::to_string(force(u)) + "\n";
    }
    put("history.csv", text);
  }

  void expect_refused(const std::string& fact, const std::string& options = "")
  {
    const auto files = [&] { return std::distance(fs::recursive_directory_iterator(folder), {}); };
    std::ofstream(folder / "out"), std::ofstream(folder / "err");
    const auto before = files();
    const std::string command = "cd '" + folder.string() +
                                "' && '" INTERLOCK_PROGRAM "' drop run " + options + " >out 2>err";
    const int status = std::system(command.c_str());
    const std::string err = file_text(folder / "err");
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 2) << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
    EXPECT_EQ(err.find("interlock: error: "), 0u) << err;
    EXPECT_NE(err.find(".\n"), std::string::npos) << err;
    EXPECT_NE(err.find(fact), std::string::npos) << err;
    EXPECT_EQ(files(), before) << err;
  }

  fs::path run_folder;
};
} // namespace

TEST_F(Drop, NotTheFolderOfARun)
{
  put("runs.csv", "name\n");
  expect_refused("is a study; give the folder of one of its runs");
  fs::remove(run_folder / "runs.csv");
  fs::remove(run_folder / "used.prm");
  expect_refused("holds no used.prm");
  fs::remove_all(run_folder);
  expect_refused("The folder \"run\" does not exist");
}

TEST_F(Drop, OfTwoRuns)
{
  put("summary.json", "{\"results\": {}, \"parameters_hash\": \"0123456789abcdef\"}\n");
  expect_refused("do not belong together");
}

TEST_F(Drop, WithoutAPull)
{
  put("used.prm", "include " INTERLOCK_SOURCE_DIR "/tests/regression/tiny_heap.prm\n");
  expect_refused("has no pull: its experiment is \"heap\", not \"pull-out\"");
}

TEST_F(Drop, OfARunThatIsNotFinished)
{
  fs::remove(run_folder / "summary.json");
  expect_refused("is not finished, it has no summary.json");
  put("summary.json", "{\"results\": {");
  expect_refused("is not finished");
}

TEST_F(Drop, WithTooFewRows)
{
  put_history([](double) { return 1.; }, 4);
  expect_refused("has 4 rows that may be used, too few to see a drop within 2 mm");
  expect_refused("has 4 rows that may be used, too few to see a drop within 0.3 mm",
                 "--within 0.0003");
  put_history([](double u) { return 100 - u; });
  expect_refused("one every 0.075 mm; run the case with more Output/Records", "--within 0.0003");
  fs::remove(run_folder / "history.csv");
  expect_refused("has 0 rows");
}

// What is beyond the displacement from which on the pull is not to be used does not count.
TEST_F(Drop, BeforeThePullIsNotToBeUsed)
{
  put("summary.json", "{\"results\": {\"not_usable_from_mm\": 1.45}}\n");
  expect_refused("has no drop: the force never falls from a maximum");
}

TEST_F(Drop, WithoutADrop)
{
  put_history([](double u) { return 5e4 * u; });
  expect_refused("has no drop: the force never falls from a maximum");
  put_history([](double u) { return u < 1.55e-3 ? std::min(1e5 * u, 140.) : 135; });
  expect_refused("from 140 N to 135 N at 1.60 mm, less than a tenth of the highest force, 140 N");
}

TEST_F(Drop, WithAnotherWindowThanThePullAllows)
{
  expect_refused("The option --within is 2 m, but the whole pull is 0.003 m long", "--within 2");
  expect_refused("The option --within is -0.001 m, but must be greater than 0", "--within -0.001");
}

TEST_F(Drop, WithoutTheStateBeforeThePull)
{
  fs::remove(run_folder / "state_before_pull.h5");
  expect_refused("its state_before_pull.h5 is not there any more");
  put("used.prm", "include " INTERLOCK_SOURCE_DIR "/tests/regression/tiny_pull_out.prm\n"
                  "set Start from = gone.h5\n");
  expect_refused("gone.h5\", is there any more");
}
