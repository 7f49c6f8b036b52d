// Study files that are wrong, in themselves or in the runs that they describe. Each is answered
// with one sentence that names file, line and entry, exit code 2, and nothing on the disk.
#include "tests/temporary_folder.h"

#include <algorithm>

#include <sys/wait.h>

namespace fs = std::filesystem;

namespace
{
class BadStudy : public TemporaryFolderTest
{
protected:
  // Runs "interlock study" inside the empty folder `work`.
  void run(const std::string& text, const std::string& options = "")
  {
    fs::create_directories(folder / "work");
    write("study.prm",
          "set Base case = " INTERLOCK_SOURCE_DIR "/tests/regression/" + base + "\n" + text);
    const std::string command = "cd '" + (folder / "work").string() +
                                "' && '" INTERLOCK_PROGRAM "' study ../study.prm " + options +
                                " >../out 2>../err";
    const int status = std::system(command.c_str());
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    err = file_text(folder / "err");
  }

  void refused(const std::string& text, const std::vector<std::string>& facts,
               const std::string& options = "")
  {
    run(text, options);
    EXPECT_EQ(code, 2) << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
    EXPECT_EQ(err.find("interlock: error: "), 0u) << err;
    for (const std::string& fact : facts)
      EXPECT_NE(err.find(fact), std::string::npos) << fact << ": " << err;
    EXPECT_TRUE(fs::is_empty(folder / "work")) << "something was written";
  }
  static std::string parameters(const std::string& line)
  {
    return "subsection Parameters\n  " + line + "\nend\n";
  }

  std::string base = "tiny_pull_out.prm", err;
  int code = -1;
};
} // namespace

TEST_F(BadStudy, ItsOwnEntries)
{
  refused("set Desing = grid\n", {"study.prm, line 2", "\"Desing\"", "\"Design\""});
  refused("set Design = hypercube\n", {"study.prm, line 2", "\"hypercube\"", "latin hypercube"});
  refused("set Fillings = 1, 1\n", {"study.prm, line 2", "\"1\" twice"});
  refused("set Samples = 4\n", {"study.prm, line 2", "\"Samples\"", "draws none"});
  refused("set Design = sobol\n" + parameters("set Pull/Speed = 0.1 to 0.2"),
          {"\"Samples\"", "2 or more"});
  refused("subsection Measures\n  set Forces at = 2 mm\nend\n", {"line 3", "\"2 mm\"", "in m"});
  refused("subsection Measures\n  set Confidence = 95\nend\n", {"line 3", "\"95\""});
  base = "no_such_case.prm";
  refused("", {"\"Base case\"", "no_such_case.prm", "no such file"});
}

TEST_F(BadStudy, Levels)
{
  refused(parameters("set Pull/Speed ="), {"study.prm, line 3", "Pull/Speed", "no values"});
  refused(parameters("set Pull/Speed = 0.1,, 0.2"), {"line 3", "empty place"});
  refused(parameters("set Pull/Speed = 0.2 to 0.1"), {"line 3", "above the lower"});
  refused(parameters("set Pull/Speed = 0.1 to 0.2 in 1"), {"line 3", "from 2 to 1000"});
  refused(parameters("set Pull/Speed = 0 to 0.2 in 3 log"), {"line 3", "begin above 0"});
  refused(parameters("set Pull/Speed = 0.1 to 0.2 by 3"), {"line 3", "LOW to HIGH in COUNT"});
  refused(parameters("set ribs = rigid: Geogrid/Rigid, soft:"),
          {"line 3", "\"Geogrid/Rigid\"", "\"=\""});
  refused(parameters("set ribs = rigid: Geogrid/Rigid=true, soft"),
          {"line 3", "\"soft\"", "NAME:"});
  refused(parameters("set Start from = a, b"), {"line 3", "\"Start from\"", "cannot be varied"});
  refused("set Fillings = 1, 2\n" + parameters("set Filling/Seed = 3, 4"),
          {"\"Filling/Seed\"", "\"filling\""});
}

// By the same checks as `interlock run`, with the line of the study file.
TEST_F(BadStudy, EntriesOfTheBaseCase)
{
  refused(parameters("set Geogrid/Young modulus = 1e9, 2e9"),
          {"study.prm, line 3", "\"Geogrid/Young modulus\"", "\"Geogrid/Youngs modulus\""});
  refused(parameters("set Pull/Speed = 0.1, -0.2"),
          {"study.prm, line 3", "\"Pull/Speed\"", "\"-0.2\""});
  refused("subsection Fixed\n  set Pull/Sped = 1\nend\n", {"study.prm, line 3", "\"Pull/Speed\""});
  refused("set Fillings = 1, two\n", {"study.prm, line 2", "\"Filling/Seed\"", "\"two\""});
  // One of the combinations alone is wrong: edges rounder than the rib is thick.
  refused(parameters("set Geogrid/Edge rounding = 0.0005, 0.002"),
          {"study.prm, line 3", "Edge rounding"});
}

TEST_F(BadStudy, States)
{
  base = "tiny_heap.prm";
  refused("set Start from = packed\n", {"study.prm", "\"Start from\"", "\"heap\"", "pull-out"});
  base = "tiny_pull_out.prm";
  refused("set Start from = packed\nsubsection Fixed\n  set Start from = a.h5\nend\n",
          {"study.prm, line 4", "\"Start from\""});
}

TEST_F(BadStudy, CommandLine)
{
  refused("", {"--jobs"}, "--jobs 0");
  refused("", {"--task", "0 to 0"}, "--task 7");
  // A folder that holds something else.
  run("", "--check -o .");
  EXPECT_EQ(code, 0) << err;
  EXPECT_TRUE(fs::is_empty(folder / "work")) << "--check has written something";
}
