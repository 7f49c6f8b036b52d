// `interlock report` as a process. It takes figures that the user's environment keeps from being
// drawn, a script that is found beside a program that was installed or copied and is not taken, a
// reason that is not the script's own, a page that a folder with figures does not get, or a folder
// with the parameters of one run and the results of another one that is drawn, to fail.
#include "apps/case_hash.h"
#include "apps/figure_script.h"
#include "apps/shared_files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include <sys/wait.h>

using namespace interlock;
namespace fs = std::filesystem;

namespace
{
class Report : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    // A name that a shell would take apart.
    run_folder = folder / "two words; 'n' more";
    put(run_folder / "history.csv",
        "time [s],displacement [m],pull_force [N]\n0,0,0\n0.1,1e-3,100\n0.2,2e-3,150\n");
    put(run_folder / "used.prm",
        "set Experiment = pull-out\nsubsection Pull\n  set Speed = 1\nend\n");
  }

  static void put(const fs::path& file, const std::string& text)
  {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }

  static std::string word(const fs::path& path)
  {
    std::string result = "'";
    for (const char letter : path.string())
      result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return result + "'";
  }

  // With the variables of `environment` ("A=b C=d").
  void report(const std::string& environment = "", const fs::path& program = INTERLOCK_PROGRAM)
  {
    const std::string command = "cd " + word(folder) + " && env " + environment + " " +
                                word(program) + " report " + word(run_folder) + " >out 2>err";
    const int status = std::system(command.c_str());
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    err = file_text(folder / "err");
  }

  // The program as somebody installs it, with this script for its figures and a short one for its
  // page.
  fs::path installed(const std::string& script) const
  {
    fs::create_directories(folder / "usr/bin");
    fs::copy_file(INTERLOCK_PROGRAM, folder / "usr/bin/interlock",
                  fs::copy_options::overwrite_existing);
    put(folder / "usr/share/interlock/apps/figures.py", script);
    put(folder / "usr/share/interlock/apps/report.py",
        "import sys\nprint('page of', sys.argv[1])\n");
    return folder / "usr/bin/interlock";
  }

  bool has_figure() const { return fs::exists(run_folder / "figures" / "force_displacement.png"); }

  fs::path run_folder;
  int code = -1;
  std::string err;
};
} // namespace

TEST_F(Report, DrawsWhateverTheEnvironmentIs)
{
  put(folder / "foreign/numpy/__init__.py", "raise ImportError('for another Python')\n");
  put(folder / "matplotlibrc", "backend: no_such_backend\nfont.size: many\n");
  // What modules, virtual environments and settings export; a home that cannot be written; nothing.
  for (const std::string& environment :
       {"PYTHONPATH=" + word(folder / "foreign") +
            " PYTHONHOME=/opt/nothing MPLBACKEND=no_such_backend MATPLOTLIBRC=" +
            word(folder / "matplotlibrc"),
        std::string("HOME=/proc/no/home"), std::string("-i")}) {
    report(environment);
    EXPECT_EQ(code, 0) << environment << '\n' << err;
    EXPECT_EQ(err, "") << environment;
    EXPECT_TRUE(has_figure()) << environment;
    EXPECT_TRUE(fs::exists(run_folder / "report.html")) << environment;
    fs::remove_all(run_folder / "figures");
    fs::remove(run_folder / "report.html");
  }
}

TEST_F(Report, TakesTheScriptOfAnInstalledProgram)
{
  const fs::path program = installed("import os, sys\n"
                                     "print(sys.argv[1])\n"
                                     "print(sorted(set(os.environ) - {'LC_ALL', 'LC_CTYPE'}))\n"
                                     "print('a word of warning', file=sys.stderr)\n");
  report("-i HOME=/h PYTHONPATH=/p LD_LIBRARY_PATH=/l HDF5_PLUGIN_PATH=/x", program);
  EXPECT_EQ(code, 0) << err;
  EXPECT_EQ(file_text(folder / "out"),
            run_folder.string() + "\n['HOME']\npage of " + run_folder.string() + '\n');
  EXPECT_EQ(err, "a word of warning\n");
}

// The last line of a traceback, the last sentence of a script, or the number of a signal.
TEST_F(Report, GivesTheScriptsOwnReason)
{
  report("", installed("import no_such_module_at_all\n"));
  EXPECT_EQ(code, 3);
  EXPECT_NE(err.find("interlock: error: the figures could not be drawn: ModuleNotFoundError: No "
                     "module named 'no_such_module_at_all' (all of it: /usr/bin/python3 -I "),
            std::string::npos)
      << err;
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;

  report("", installed("import sys\nsys.exit('The colours ran out')\n"));
  EXPECT_EQ(code, 3);
  EXPECT_NE(err.find("could not be drawn: The colours ran out (all"), std::string::npos) << err;

  report("", installed("import os\nos.kill(os.getpid(), 9)\n"));
  EXPECT_EQ(code, 3);
  EXPECT_NE(err.find("could not be drawn: figures.py was ended by signal 9."), std::string::npos)
      << err;
}

TEST_F(Report, RefusesAFolderWithNothingToDraw)
{
  fs::remove(run_folder / "history.csv");
  report();
  EXPECT_EQ(code, 2);
  EXPECT_EQ(err.find("interlock: error: " + run_folder.string() + ": there is no history.csv"), 0u)
      << err;
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
}

TEST_F(Report, NamesTheScriptThatIsNotThere)
{
  const apps::ScriptResult result = apps::run_figure_script("no_such_script.py", {"x"});
  EXPECT_EQ(result.status, 127);
  const std::string file = (apps::shared_folder() / "apps/no_such_script.py").string();
  EXPECT_EQ(result.reason.find("the script " + file + " does not exist"), 0u) << result.reason;
}

TEST_F(Report, TakesTheSharedFolderThatTheEnvironmentNames)
{
  setenv("INTERLOCK_SHARE", folder.c_str(), 1);
  const apps::ScriptResult result = apps::run_figure_script("figures.py", {"x"});
  unsetenv("INTERLOCK_SHARE");
  EXPECT_EQ(result.status, 127);
  EXPECT_NE(result.reason.find(folder.string()), std::string::npos) << result.reason;
}

// --- Of two runs -------------------------------------------------------------------------------

TEST_F(Report, RefusesParametersOfOneRunBesideResultsOfAnother)
{
  const std::string hash = apps::case_hash(run_folder / "used.prm");
  put(run_folder / "summary.json", "{\"results\": {}, \"parameters_hash\": \"" + hash + "\"}\n");
  report();
  EXPECT_EQ(code, 0) << err;
  fs::remove_all(run_folder / "figures");

  put(run_folder / "used.prm",
      "set Experiment = pull-out\nsubsection Pull\n  set Speed = 2\nend\n");
  report();
  EXPECT_EQ(code, 2) << err;
  EXPECT_NE(err.find("do not belong together"), std::string::npos) << err;
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  EXPECT_FALSE(has_figure());
}

TEST_F(Report, HashOfACaseIsThatOfItsEntriesAlone)
{
  const auto hash = [&](const std::string& text) {
    put(folder / "any.prm", text);
    return apps::case_hash(folder / "any.prm");
  };
  const std::string one = hash("set A = 1\nsubsection Pull\n  set Speed = 2\nend\n");
  EXPECT_EQ(hash("# more\nsubsection Pull\nset Speed=2\nend\nset A = 1 # text\n"), one);
  EXPECT_NE(hash("set A = 2\nsubsection Pull\n  set Speed = 2\nend\n"), one);
  EXPECT_NE(hash("set A = 1\nsubsection Pulls\n  set Speed = 2\nend\n"), one);
  EXPECT_NE(hash("set A = 1\nset Speed = 2\n"), one);
}
