// The built program as a process: exit codes, one rank's words on the standard error, and nothing
// on the disk. It takes bad input that ends with another code than 2, is silent, is said on the
// standard output, or leaves a file behind, to fail.
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <map>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/wait.h>

namespace fs = std::filesystem;

namespace
{
const std::string quick = std::string(INTERLOCK_SOURCE_DIR) + "/cases/pullout/quick.prm";

class Program : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    fs::create_directories(folder / "work");
  }

  // Runs `launcher` interlock `arguments` inside the empty folder `work`.
  void run(const std::string& arguments, const std::string& launcher = "")
  {
    const std::string command = "cd '" + (folder / "work").string() + "' && " + launcher +
                                " '" INTERLOCK_PROGRAM "' " + arguments + " >../out 2>../err";
    const int status = std::system(command.c_str());
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    out = text_of(folder / "out");
    err = text_of(folder / "err");
  }

  static std::string text_of(const fs::path& file)
  {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  void expect_refusal(const std::vector<std::string>& words)
  {
    EXPECT_EQ(code, 2) << err;
    EXPECT_EQ(out, "");
    EXPECT_EQ(err.find("interlock: error: "), 0u) << err;
    for (const std::string& word : words) EXPECT_NE(err.find(word), std::string::npos) << err;
    EXPECT_TRUE(fs::is_empty(folder / "work")) << "something was written";
  }

  int code = -1;
  std::string out, err;
};
} // namespace

TEST_F(Program, RefusesAnUnknownEntry)
{
  run("run " + quick + " --set 'Geogrid/Young modulus=2e9'");
  expect_refusal({"\"Geogrid/Young modulus\"", "\"Geogrid/Youngs modulus\""});
}

TEST_F(Program, RefusesAUnitAndANegativeStiffnessTogether)
{
  run("run " + quick + " --set 'Geogrid/Youngs modulus=2.4 GPa' --set 'Contact/Box stiffness=-1'");
  expect_refusal({"\"2.4 GPa\"", "in Pa", "\"Contact/Box stiffness\" is \"-1\""});
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 2);
}

TEST_F(Program, RefusesAFileThatLacksAPhysicalValue)
{
  run("template pull-out");
  EXPECT_EQ(code, 0);
  const std::string line = "  set Density = 910\n";
  const auto begin = out.find(line);
  ASSERT_NE(begin, std::string::npos);
  std::ofstream(folder / "lacks.prm") << out.erase(begin, line.size());
  run("run ../lacks.prm");
  expect_refusal({"../lacks.prm", "\"Product/Density\" is missing", "in kg/m3"});
}

TEST_F(Program, RefusesAMissingFolderOfScans)
{
  run("run " + quick + " --set Stones/Folder=no_scans --set 'Stones/Length unit=0.001'");
  expect_refusal({"\"Stones/Folder\"", "no_scans"});
}

TEST_F(Program, RefusesAGeogridLargerThanTheBox)
{
  run("run " + quick + " --set 'Box/Width=0.19'");
  expect_refusal({"\"Geogrid/Apertures across\"", "0.199 m wide", "0.19 m wide"});
}

TEST_F(Program, RefusesABoxInWhichAStoneDoesNotFit)
{
  run("run " + quick +
      " --set Box/Width=0.05 --set 'Geogrid/Apertures across=1' "
      "--set 'Product/Pitch across=0.04' --set Stones/Count=2");
  EXPECT_EQ(code, 2) << err;
  EXPECT_NE(err.find("m across, but the box is only 0.05 m wide"), std::string::npos) << err;
  EXPECT_TRUE(fs::is_empty(folder / "work")) << "something was written";
}

TEST_F(Program, RefusesATimeStepAboveTheStableOne)
{
  run("run " + quick + " --set Stones/Count=1 --set Time/Step=1e-3");
  EXPECT_EQ(code, 2) << err;
  EXPECT_NE(err.find("interlock: error: "), std::string::npos) << err;
  EXPECT_NE(err.find("Time/Step"), std::string::npos) << err;
  EXPECT_TRUE(fs::is_empty(folder / "work")) << "something was written";
}

TEST_F(Program, RefusesAMissingFileAndAFileInThePlaceOfTheOutputFolder)
{
  run("run no.prm");
  expect_refusal({"\"no.prm\"", "cannot be read"});
  run("run " + quick + " --output ../out/results");
  expect_refusal({"../out/results", "is a file"});
}

TEST_F(Program, RefusesUnknownCommandsAndOptions)
{
  run("rnu " + quick);
  expect_refusal({"\"rnu\"", "\"run\""});
  run("run " + quick + " --outptu here");
  expect_refusal({"--outptu"});
  run("run");
  expect_refusal({"file"});
  run("help rnu");
  expect_refusal({"\"rnu\"", "--help"});
  run("run " + quick + " -o ''");
  expect_refusal({"--output is empty"});
  run("template settle");
  expect_refusal({"settle"});
  run("report no_such_folder");
  expect_refusal({"no_such_folder"});
}

// What all ranks refuse is said once, and nothing is written.
TEST_F(Program, TwoRanksRefuseInOneSentence)
{
  // Machines without Open MPI's launcher cannot ask for two ranks in this way either.
  if (std::system("mpirun --version >/dev/null 2>&1") != 0) return;
  const std::string two = "mpirun --allow-run-as-root --oversubscribe -n 2";
  const std::map<std::string, std::string> refused = {
      {"run " + quick + " --set Box/Length=-1", "Length"},
      {"run " + quick + " --set 'Start from=no_such_state.h5'", "no_such_state.h5"},
      {"run no_such_case.prm", "no_such_case.prm"},
      {"run " + quick + " -o ''", "--output"},
      {"run " + quick + " --no-such-option", "--no-such-option"},
      {"template pull-out", "2 ranks"},
      {"rnu", "2 ranks"}};
  for (const auto& [command, reason] : refused) {
    run(command, two);
    EXPECT_EQ(code, 2) << command << '\n' << err;
    const auto sentence = err.find("interlock: error: ");
    ASSERT_NE(sentence, std::string::npos) << command << '\n' << err;
    EXPECT_NE(err.find(reason, sentence), std::string::npos) << command << '\n' << err;
    EXPECT_EQ(err.find("interlock: error", sentence + 1), std::string::npos) << command << err;
  }
  EXPECT_TRUE(fs::is_empty(folder / "work")) << "something was written";
}

TEST_F(Program, TellsItsVersionAndItsUse)
{
  run("--version");
  EXPECT_EQ(code, 0);
  EXPECT_EQ(out.find("interlock "), 0u) << out;
  run("--help");
  EXPECT_EQ(code, 0);
  for (const char* command : {"run", "check", "clump", "stones", "template", "report"})
    EXPECT_NE(out.find(std::string("\n  ") + command), std::string::npos) << command;
  EXPECT_EQ(err, "");
}

TEST_F(Program, ExplainsItselfWhenNothingIsAsked)
{
  run("--help");
  const std::string overview = out;
  for (const char* words : {"", "help"}) {
    run(words);
    EXPECT_EQ(code, 0);
    EXPECT_EQ(out, overview);
  }
  run("run --help");
  const std::string of_run = out;
  run("help run");
  EXPECT_EQ(out, of_run);
}

// The environment of an srun step, and one without PATH, ssh and a folder for temporary files: no
// command needs MPI's permission to start.
TEST_F(Program, StartsWhereMpiDoesNot)
{
  const std::string srun =
      "env SLURM_JOB_ID=5 SLURM_JOBID=5 SLURM_NODELIST=n1 SLURM_NNODES=1 SLURM_TASKS_PER_NODE=1 "
      "SLURM_NTASKS=1 SLURM_PROCID=0 SLURM_LOCALID=0 SLURM_NODEID=0 SLURM_STEP_ID=0 "
      "SLURM_STEPID=0 SLURM_STEP_NODELIST=n1 SLURM_STEP_NUM_NODES=1 SLURM_STEP_NUM_TASKS=1 "
      "SLURM_STEP_TASKS_PER_NODE=1 ";
  for (const std::string& where : {srun, std::string("env -u PATH TMPDIR=/nonexistent ")}) {
    run("--version", where);
    EXPECT_EQ(code, 0) << err;
    EXPECT_EQ(out.find("interlock "), 0u) << out;
    run("template heap", where);
    EXPECT_EQ(code, 0) << err;
    EXPECT_EQ(out.find("# "), 0u);
    // A run starts, too: its answer is about its input.
    run("run " + quick + " --set Stones/Count=1 --set Time/Step=1e-3", where);
    EXPECT_EQ(code, 2);
    EXPECT_NE(err.find("Time/Step"), std::string::npos) << err;
  }
}

// PETSc's options of a user, such as -log_view, are about his own programs.
TEST_F(Program, PrintsNothingOfPetscs)
{
  std::ofstream(folder / "work" / ".petscrc") << "-log_view\n";
  run("template laboratory");
  EXPECT_EQ(code, 0);
  EXPECT_EQ(out.find("Summary"), std::string::npos);
}

TEST_F(Program, TakesOptionsBeforeTheFile)
{
  run("run --set Time/Step=1e-3 --set Stones/Count=1 " + quick);
  EXPECT_EQ(code, 2);
  EXPECT_NE(err.find("Time/Step"), std::string::npos) << err;
}
