// `interlock clump` and `interlock stones` as processes: what they refuse, and that they refuse it
// before they write. Takes a scan or a clump that is written over, a stone that is lost in silence,
// another exit code than 2, or a file that stays behind, to fail.
#include "dem/stones/synthetic_stone.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include <sys/wait.h>

namespace
{
namespace fs = std::filesystem;
const std::string spheres = " --d-min 0.004 --r-min 0.004 --max-spheres 5 ";

class ClumpProgram : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    work = folder / "work";
    for (const char* name : {"a", "b"}) fs::create_directories(work / name);
    const auto stones = interlock::dem::make_stones(2, 7);
    interlock::dem::write_stl((work / "a/scan.stl").string(), stones[0]);
    interlock::dem::write_stl((work / "b/scan.stl").string(), stones[1]);
    interlock::dem::write_stl((work / "a/x.stl").string(), stones[1]);
  }

  // Runs the shell's `command`, in which $I is the program, among the stones.
  void run(const std::string& command)
  {
    before = contents();
    const std::string all = "cd '" + work.string() + "' && I='" INTERLOCK_PROGRAM "' && { " +
                            command + "; } >../out 2>../err";
    const int status = std::system(all.c_str());
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    out = text_of(folder / "out");
    err = text_of(folder / "err");
  }

  // `words` in one sentence, and every file as it was.
  void expect_refusal(const std::string& command, const std::vector<std::string>& words)
  {
    run(command);
    EXPECT_EQ(code, 2) << command << "\n" << err;
    EXPECT_EQ(out, "") << command;
    EXPECT_EQ(err.find("interlock: error: "), 0u) << err;
    EXPECT_EQ(err.find('\n') + 1, err.size()) << err;
    for (const std::string& word : words) EXPECT_NE(err.find(word), std::string::npos) << err;
    EXPECT_EQ(contents(), before) << command;
  }

  static std::string text_of(const fs::path& file)
  {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::map<std::string, std::string> contents() const
  {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(work))
      all[entry.path().string()] = entry.is_regular_file() ? text_of(entry.path()) : "folder";
    return all;
  }

  fs::path work;
  std::map<std::string, std::string> before;
  int code = -1;
  std::string out, err;
};

TEST_F(ClumpProgram, StonesAreNotWrittenOver)
{
  const std::string one = "$I clump a/x.stl" + spheres;
  expect_refusal(one + "-o a/x.stl", {"'a/x.stl'", "that is the stone"});
  expect_refusal(one + "--report a/../a/x.stl", {"'a/../a/x.stl'", "that is the stone 'a/x.stl'"});
  expect_refusal(one + "--report a/scan.stl", {"'a/scan.stl'", "named as a stone"});
  expect_refusal("$I clump a" + spheres + "-o out --report a/scan.stl",
                 {"that is the stone 'a/scan.stl'"});
  fs::create_symlink("x.stl", work / "a/link.json");
  expect_refusal(one + "-o a/link.json", {"that is the stone 'a/x.stl'"});
}

TEST_F(ClumpProgram, OutputsDoNotMeet)
{
  const std::string one = "$I clump a/x.stl --density 2650" + spheres;
  expect_refusal(one + "-o z.mol --format lammps",
                 {"'z.mol'", "the clump of 'a/x.stl' goes there"});
  expect_refusal(one + "-o q.clump.json --report ./q.clump.json",
                 {"The report", "'./q.clump.json'", "the clump of 'a/x.stl' goes there"});
  expect_refusal(one + "-o q.json --format liggghts --report q.multisphere.in",
                 {"the liggghts file of 'a/x.stl' goes there"});
  expect_refusal(one + "-o q.json --format mercury --report q.mclump/readme.txt",
                 {"the mercury file of 'a/x.stl' goes there"});
  expect_refusal("$I clump a/scan.stl b/scan.stl" + spheres + "-o out",
                 {"the clump of 'a/scan.stl'", "clump of 'b/scan.stl'", "out/scan.clump.json"});
}

TEST_F(ClumpProgram, PlacesThatCannotBeWritten)
{
  const std::string one = "$I clump a/x.stl" + spheres;
  expect_refusal(one + "--report /proc/r.json", {"'/proc/r.json'", "no file can be made"});
  expect_refusal(one + "-o new/x.clump.json --report a/x.stl/r.json", {"a/x.stl/r.json"});
  expect_refusal("$I clump a" + spheres + "-o b/scan.stl", {"b/scan.stl", "is a file"});
  fs::create_directories(work / "a/x.clump.json");
  expect_refusal(one + "-o a", {"'a/x.clump.json'", "is a folder"});
  expect_refusal("$I stones --count 1 -o a/x.stl", {"a/x.stl", "is a file"});
}

TEST_F(ClumpProgram, Options)
{
  const std::string one = "$I clump a/x.stl" + spheres;
  for (const char* density : {"nan", "inf", "0", "-2650"})
    expect_refusal(one + "--density " + density, {"--density is", "greater than 0"});
  for (const char* density : {"2.65", "1e300"})
    expect_refusal(one + "--density " + density, {"--density is", "1000 to 8000 kg/m3"});
  expect_refusal(one + "--density 2.65", {"2.65 g/cm3 are 2650 kg/m3", "--unusual"});
  expect_refusal(one + "--target-volume-error -1", {"--target-volume-error is -1 %"});
  expect_refusal(one + "--target-inertia-error 100", {"--target-inertia-error is 100 %"});
  expect_refusal(one + "--seed -1", {"--seed is -1", "0 to"});
  expect_refusal("$I stones --count 1 --seed=-1 -o s", {"--seed is -1", "0 to"});
  expect_refusal("$I stones --cuont 1 -o s", {"\"--cuont\"", "\"--count\""});
  expect_refusal("$I clump a/x.stl --d-mni=0.004 --r-min 0.004", {"\"--d-mni\"", "\"--d-min\""});
  expect_refusal("$I clump", {"No stone is given"});
  expect_refusal("$I clump --density 2650 --format lammps", {"No stone is given"});
}

TEST_F(ClumpProgram, NamesOfStones)
{
  std::ofstream(work / "n.txt") << "0 0 0 0 0 1\n";
  expect_refusal("$I clump n.txt" + spheres, {"'n.txt'", ".stl", ".xyz"});
  expect_refusal("$I clump no.txt" + spheres, {"'no.txt'", "does not exist"});
  fs::create_directories(work / "empty");
  expect_refusal("$I clump empty" + spheres, {"'empty'", ".xyz"});
}

// Words behind --format: the stone is no format.
TEST_F(ClumpProgram, FormatLeavesTheStone)
{
  run("$I clump --format lammps,csv a/x.stl --density 2650" + spheres + "-o x.clump.json");
  EXPECT_EQ(code, 0) << err;
  EXPECT_TRUE(fs::exists(work / "x.mol") && fs::exists(work / "x.csv"));
  run("$I clump --density 2650" + spheres + "-o y.clump.json --format csv vtk a/x.stl");
  EXPECT_EQ(code, 0) << err;
  EXPECT_TRUE(fs::exists(work / "y.csv") && fs::exists(work / "y.vtp"));
  run("$I clump --format lammps,csv a/x.stl --density 2650" + spheres + "-o x.clump.json");
  // Five spheres cannot carry the moments of the stone.
  EXPECT_NE(out.find("their moments are off by up to"), std::string::npos) << out;
}

TEST_F(ClumpProgram, GoesOnAfterABadStone)
{
  std::ofstream(work / "a/bad.stl") << "no mesh";
  fs::rename(work / "a/x.stl", work / "a/x\xfc.stl"); // no UTF-8
  run("$I clump a" + spheres + "-o out");
  EXPECT_EQ(code, 2);
  EXPECT_NE(err.find("'a/bad.stl'"), std::string::npos) << err;
  EXPECT_NE(err.find("interlock: error: 1 of 3 stones was refused.\n"), std::string::npos) << err;
  for (const char* name : {"scan.clump.json", "x\xfc.clump.json", "clumps.report.json"})
    EXPECT_TRUE(fs::exists(work / "out" / name)) << name;
  EXPECT_NE(text_of(work / "out/clumps.report.json").find("\"refused\""), std::string::npos);
}

// LIGGGHTS refuses one sphere, and then there is no clump file either.
TEST_F(ClumpProgram, StonesAreWrittenWholeOrNotAtAll)
{
  expect_refusal("$I clump a/x.stl --d-min 0.004 --r-min 0.004 --max-spheres 1 --density 2650 "
                 "--format lammps,liggghts -o x.clump.json",
                 {"'x' has one sphere"});
}

// A Mac leaves "._NAME" beside each file on a disk that is not its own.
TEST_F(ClumpProgram, HiddenFilesAreNoStones)
{
  for (const char* name : {"a/._scan.stl", "a/._x.stl", "hidden/._x.stl"}) {
    fs::create_directories((work / name).parent_path());
    std::ofstream(work / name) << std::string("\0\5\x16\7", 4);
  }
  expect_refusal("$I clump hidden" + spheres,
                 {"'hidden' has no .stl", "names that start with a dot do not count"});
  expect_refusal("$I clump a/._x.stl" + spheres + "-o x.clump.json", {"a/._x.stl", "AppleDouble"});
  run("$I clump a" + spheres + "-o out");
  EXPECT_EQ(code, 0) << err;
  EXPECT_NE(out.find("2 clumps in 'out'"), std::string::npos) << out;
}

// Two or three balls of a stone of 40 mm, drawn anywhere on it, rarely meet.
TEST_F(ClumpProgram, WarnsOfAClumpInPieces)
{
  int pieces = 0;
  for (const char* seed : {"1", "2", "3"}) {
    run("$I clump a/x.stl --d-min 0.004 --r-min 0.002 --max-spheres 3 --seed " + std::string(seed) +
        " -o x.clump.json");
    EXPECT_EQ(code, 0) << err;
    const bool is_apart =
        text_of(work / "x.report.json").find("\"groups\": 1,") == std::string::npos;
    pieces += is_apart;
    EXPECT_EQ(out.find("groups that do not touch each other: choose a larger --max-spheres and "
                       "--d-min not above --r-min, or --sphere-order gain.") != std::string::npos,
              is_apart)
        << out;
    EXPECT_NE(out.find("less volume than the stone: choose a larger --max-spheres."),
              std::string::npos)
        << out;
  }
  EXPECT_GT(pieces, 0);
}

TEST_F(ClumpProgram, TheCommonCasesGoThrough)
{
  run("$I clump a/x.stl" + spheres + "-o run1.clump.json");
  EXPECT_EQ(code, 0) << err;
  EXPECT_TRUE(fs::exists(work / "run1.report.json")) << "the report is named after the clump";
  run("$I clump a/x.stl" + spheres + "-o b");
  EXPECT_EQ(code, 0) << err;
  EXPECT_TRUE(fs::exists(work / "b/x.clump.json") && fs::exists(work / "b/x.report.json"));
  run("$I clump a/x.stl" + spheres + "-o deep/er/x.clump.json --report other/r.json");
  EXPECT_EQ(code, 0) << err;
  EXPECT_TRUE(fs::exists(work / "deep/er/x.clump.json") && fs::exists(work / "other/r.json"));
  const std::string report = text_of(work / "other/r.json");
  for (const char* entry : {"origin_m", "rotation_w_x_y_z", "axes_are_distinct"})
    EXPECT_NE(report.find(entry), std::string::npos) << entry;
  run("$I stones --count 1 -o a");
  EXPECT_NE(out.find("Note: 'a' holds 2 other stone files too."), std::string::npos) << out;
}

// A cube has no longest axis.
TEST_F(ClumpProgram, SaysThatSizesDependOnTheFrame)
{
  std::ofstream cube(work / "cube.obj");
  for (int i = 0; i < 8; ++i)
    cube << "v " << (i & 1) << " " << (i >> 1 & 1) << " " << i / 4 << "\n";
  cube << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  cube.close();
  run("$I clump cube.obj --unit cm --d-min 0 --r-min 0");
  EXPECT_EQ(code, 0) << err;
  EXPECT_NE(out.find("depend on how the file is turned"), std::string::npos) << out;
  EXPECT_NE(text_of(work / "cube.report.json").find("\"axes_are_distinct\": false"),
            std::string::npos);
}
} // namespace
