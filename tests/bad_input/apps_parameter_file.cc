// Bad parameter files. Each test states one slip that a user makes and the words that must be in
// the answer: the place, the entry, the value and what to write instead. It takes an error that is
// not found, is found alone where there are several, or does not say where it is, to fail.
#include "apps/parameter_file.h"
#include "dem/input_error.h"
#include "tests/pull_out_text.h"
#include "tests/temporary_folder.h"

#include <boost/algorithm/string.hpp>
#include <gtest/gtest.h>

#include <fstream>

using namespace interlock;
namespace fs = std::filesystem;

namespace
{
class BadParameterFile : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("good.prm", pull_out_by_entries());
  }

  // The sentences about a file, which must be bad.
  static std::vector<std::string> errors(const fs::path& file,
                                         const std::vector<std::string>& overrides = {})
  {
    try {
      apps::read_parameter_file(file, overrides);
    } catch (const InputError& error) {
      std::vector<std::string> lines;
      boost::split(lines, std::string(error.what()), boost::is_any_of("\n"));
      return lines;
    }
    ADD_FAILURE() << "the input was accepted";
    return {};
  }

  // The sentences about the good file with one change on the command line.
  std::vector<std::string> errors_with(const std::string& change) const
  {
    return errors(folder / "good.prm", {change});
  }

  // The sentences about the good file with `replacement` instead of the line that starts with
  // `line`.
  std::vector<std::string> errors_after(const std::string& line,
                                        const std::string& replacement) const
  {
    std::string text = pull_out_by_entries();
    const auto begin = text.find("  " + line);
    EXPECT_NE(begin, std::string::npos);
    text.replace(begin, text.find('\n', begin) - begin, replacement);
    return errors(write("bad.prm", text));
  }
};

void expect_words(const std::vector<std::string>& errors, const std::vector<std::string>& words)
{
  ASSERT_EQ(errors.size(), 1u) << boost::join(errors, "\n");
  for (const std::string& word : words)
    EXPECT_NE(errors[0].find(word), std::string::npos) << "\"" << word << "\" in: " << errors[0];
  EXPECT_EQ(errors[0].back(), '.');
}

// The line of the template that starts with these words.
int line_of(const std::string& start)
{
  const std::string text = pull_out_by_entries();
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + text.find("  " + start), '\n'));
}
} // namespace

TEST_F(BadParameterFile, UnknownEntryGetsTheNearestName)
{
  expect_words(
      errors_after("set Mass damping", "  set Mass damping = 5\n  set Elements per ribs = 4"),
      {"bad.prm, line " + std::to_string(line_of("set Mass damping") + 1),
       "no entry \"Geogrid/Elements per ribs\"", "\"Geogrid/Elements per rib\""});
  expect_words(errors_with("Pul/Speed=1"), {"no entry \"Pul/Speed\"", "\"Pull/Speed\""});
}

TEST_F(BadParameterFile, EntryInTheWrongSectionGetsTheRightOne)
{
  expect_words(errors_with("Geogrid/Geogrid friction=0.5"), {"\"Contact/Geogrid friction\""});
  expect_words(errors_with("Youngs modulus=1e9"), {"\"Geogrid/Youngs modulus\""});
}

TEST_F(BadParameterFile, EntryLikeNoOtherGetsTheListOfTheSection)
{
  expect_words(errors_with("Pull/Temperature=20"), {"\"Speed\", \"Distance\", \"Ramp time\""});
  expect_words(errors_with("Weather/Temperature=20"), {"nor a section of this name"});
}

TEST_F(BadParameterFile, ValueWithItsUnitGetsTheNumberToWrite)
{
  expect_words(errors_after("set Youngs modulus", "  set Youngs modulus = 2.4 GPa"),
               {"bad.prm, line " + std::to_string(line_of("set Youngs modulus")),
                "\"Geogrid/Youngs modulus\" is \"2.4 GPa\"", "in Pa", "2.4e+09"});
  expect_words(errors_with("Geogrid/Pitch along=65mm"), {"in m", "0.065"});
  expect_words(errors_with("Contact/Stone stiffness=60 kN/m"), {"in N/m", "60000"});
  expect_words(errors_with("Pull/Speed=36 km/h"), {"\"36 km/h\"", "in m/s"});
  expect_words(errors_with("Stones/P max=10 %"), {"\"10 %\"", "at most 100", "in %"});
}

TEST_F(BadParameterFile, ValueOutsideItsRangeGetsTheRange)
{
  expect_words(errors_with("Contact/Stone stiffness=-6e7"),
               {"\"Contact/Stone stiffness\" is \"-6e7\"", "greater than 0", "in N/m"});
  expect_words(errors_with("Geogrid/Poisson ratio=0.7"),
               {"\"0.7\"", "greater than -1 and at most 0.5"});
  expect_words(errors_with("Contact/Damping ratio=2"), {"\"2\"", "from 0 to 1"});
  expect_words(errors_with("Geogrid/Apertures along=2.5"), {"\"2.5\"", "a whole number"});
  expect_words(errors_with("Geogrid/Placement=flat"), {"\"flattened\" or \"not flattened\""});
  expect_words(errors_with("Geogrid/Rigid=perhaps"), {"\"true\" or \"false\""});
  expect_words(errors_with("Pull/Speed="), {"\"Pull/Speed\" is \"\"", "in m/s"});
}

TEST_F(BadParameterFile, MissingPhysicalValueIsAskedForWithItsUnit)
{
  expect_words(errors_after("set Youngs modulus", ""),
               {"bad.prm", "\"Geogrid/Youngs modulus\" is missing", "in Pa", "Young's modulus"});
}

TEST_F(BadParameterFile, MissingFolderOfStonesIsNamed)
{
  expect_words(errors(folder / "good.prm", {"Stones/Folder=no_scans", "Stones/Length unit=0.001"}),
               {"\"Stones/Folder\"", "no_scans", "No such file or directory"});
}

TEST_F(BadParameterFile, GeogridLargerThanTheBoxIsMeasured)
{
  expect_words(errors_after("set Apertures across", "  set Apertures across = 4"),
               {"bad.prm, line " + std::to_string(line_of("set Apertures across")),
                "\"Geogrid/Apertures across\"", "0.265 m wide", "0.2 m wide"});
}

TEST_F(BadParameterFile, OtherExperimentsAreNotAvailable)
{
  expect_words(errors_with("Experiment=settle"), {"\"settle\"", "not available in this version"});
  expect_words(errors_with("Experiment=pullout"), {"\"pullout\"", "\"pull-out\""});
}

// Nobody can know which other entries are missing.
TEST_F(BadParameterFile, WithoutAnExperimentNothingElseIsMissing)
{
  expect_words(errors(write("bad.prm", "subsection Pull\n  set Speed = 0.1\nend\n")),
               {"bad.prm", "\"Experiment\" is missing", "\"pull-out\""});
}

TEST_F(BadParameterFile, EveryExperimentHasEntriesOfItsOwn)
{
  const fs::path w1 = fs::path(INTERLOCK_SOURCE_DIR) / "cases" / "benchmark" / "w1.prm";
  expect_words(errors(w1, {"Pull/Speed=1"}), {"no entry \"Pull/Speed\""});
  expect_words(errors(w1, {"Packing/Sqeeze=0.01"}), {"\"Packing/Squeeze\""});
  expect_words(errors(w1, {"Packing/Squeeze=9"}), {"\"9\"", "from 0 to 0.1"});
  expect_words(errors(w1, {"Packing/State file=none.json"}),
               {"\"Packing/State file\"", "none.json", "does not exist"});
  expect_words(errors(w1, {"Packing/Write state=state.txt"}), {"state.txt", ".json.gz"});
  expect_words(
      errors(w1, {"Packing/Write state=" + w1.parent_path().string() + "/w1_settled.json.gz"}),
      {"is the state file itself"});
  expect_words(errors(w1, {"Packing/Write state=none/state.json"}), {"folder", "does not exist"});
  expect_words(errors(w1, {"Packing/Hold still=true", "Packing/Throw spin=1"}),
               {"held still", "Throw speed"});
  expect_words(errors(w1, {"Time/Timed steps=60"}), {"50 records", "half of the 60"});
  expect_words(errors(w1, {"Neighbour lists/Inner skin=2e-3", "Neighbour lists/Middle skin=1e-3"}),
               {"0.002 m", "0.001 m"});
  expect_words(errors(w1, {"Contact/Normal damping rate=4000 1/s"}), {"in 1/s"});
}

TEST_F(BadParameterFile, BrokenLinesAreNamed)
{
  const std::string good = "include good.prm\n";
  expect_words(errors(write("bad.prm", good + "subsection Pull\nset Speed = 0.1\n")),
               {"bad.prm, line 2", "\"Pull\" has no \"end\""});
  expect_words(errors(write("bad.prm", good + "end\n")), {"bad.prm, line 2", "closes no"});
  expect_words(errors(write("bad.prm", good + "Gravity = 9.81\n")),
               {"bad.prm, line 2", "\"Gravity = 9.81\"", "set NAME = VALUE"});
  expect_words(errors(write("bad.prm", good + "set Gravity 9.81\n")), {"bad.prm, line 2", "\"=\""});
  expect_words(errors(write("bad.prm", good + "set Gravity = 9\nset Gravity = 8\n")),
               {"bad.prm, line 3", "set before", "bad.prm, line 2"});
  expect_words(errors(write("bad.prm", good + "include no.prm\n")),
               {"bad.prm, line 2", "no.prm", "does not exist"});
  expect_words(errors(write("bad.prm", good + "include bad.prm\n")),
               {"bad.prm, line 2", "includes itself"});
  expect_words(errors_with("Pull/Speed"), {"--set", "\"Pull/Speed\"", "Section/Name=value"});
}

// Every other line behind the gap would be an entry of the wrong section.
TEST_F(BadParameterFile, OneMissingEndIsOneError)
{
  std::string text = pull_out_by_entries();
  const auto end = text.find("\nend\n");
  text.erase(end + 1, 4);
  expect_words(errors(write("bad.prm", text)), {"bad.prm, line ", "\"Stones\" has no \"end\""});
}

TEST_F(BadParameterFile, AHashInANameIsAskedAbout)
{
  fs::create_directories(folder / "set");
  fs::create_directories(folder / "set # 3");
  write("set/a.stl", "solid");
  const std::string head = "include good.prm\nsubsection Stones\n  set Length unit = 0.001\n";
  expect_words(errors(write("bad.prm", head + "  set Folder = set #2\nend\n")),
               {"bad.prm, line 4", "\"#2\"", "comment", "\"set #2\""});
  expect_words(errors(write("bad.prm", head + "  set Folder = set # 3\nend\n")),
               {"bad.prm, line 4", "\"# 3\"", "\"set # 3\""});
}

TEST_F(BadParameterFile, OtherUnitsAreAskedAbout)
{
  expect_words(errors_after("set Density = 2650", "  set Density = 2.65"),
               {"bad.prm, line ", "\"Stones/Density\"", "1000 to 8000 kg/m3",
                "2.65 g/cm3 are 2650 kg/m3", "--unusual"});
  expect_words(errors_with("Geogrid/Youngs modulus=2400"), {"2400 MPa are 2.4e+09 Pa"});
  expect_words(errors_with("Contact/Stone stiffness=60"), {"60 MN/m are 6e+07 N/m"});
  expect_words(errors_with("Stones/D min=1.5"), {"\"Stones/D min\"", "1.5 mm are 0.0015 m"});
  expect_words(errors_with("Gravity=0"), {"\"Gravity\" is \"0\"", "greater than 0"});
  expect_words(errors_with("Filling/Plate speed=60"), {"60 mm/s are 0.06 m/s"});
}

TEST_F(BadParameterFile, SizesAreComparedWithEachOther)
{
  expect_words(errors_with("Box/Length=0.6"), {"\"Geogrid/Apertures along\"", "0.205 m",
                                               "0.6 m long", "9 apertures", "--unusual"});
}

TEST_F(BadParameterFile, Utf16IsNamed)
{
  expect_words(errors(write("wide.prm", std::string("\xFF\xFEs\0e\0t\0", 8))),
               {"wide.prm", "UTF-16", "UTF-8"});
}

TEST_F(BadParameterFile, UnreadableFileIsOneSentence)
{
  expect_words(errors(folder / "no.prm"), {"no.prm", "cannot be read"});
  expect_words(errors(folder), {"cannot be read"});
}

TEST_F(BadParameterFile, AllErrorsComeAtOnceInOrder)
{
  const auto all = errors(folder / "good.prm", {"Pull/Sped=1", "Box/Width=-1", "nonsense"});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NE(all[0].find("nonsense"), std::string::npos);
  EXPECT_NE(all[1].find("Pull/Sped"), std::string::npos);
  EXPECT_NE(all[2].find("Box/Width"), std::string::npos);
}
