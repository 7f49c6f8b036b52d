// Parameter files. It takes a case or the template with a value that is not the paper's (Table 6
// and section 4 of Ferellec and McDowell 2010), an override or an include that does not win, a path
// that is relative to the wrong folder, a former name of an experiment that is refused, or a
// used.prm that does not give the same run again, a dialect of text files that changes a value, or
// a usual value that is refused, to fail.
#include "apps/parameter_file.h"

#include "apps/case_templates.h"
#include "apps/experiments.h"
#include "apps/nearest_name.h"
#include "apps/parameter_scanner.h"
#include "apps/template_command.h"
#include "coupling/parameters/usual_ranges.h"
#include "dem/input_error.h"
#include "tests/pull_out_text.h"
#include "tests/temporary_folder.h"

#include <boost/algorithm/string.hpp>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

using namespace interlock;
namespace fs = std::filesystem;

namespace
{
const fs::path cases = fs::path(INTERLOCK_SOURCE_DIR) / "cases" / "pullout";

class ParameterFile : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("base.prm", pull_out_by_entries());
  }

  // Of the error; empty when there is none.
  static std::string complaint(const fs::path& file, const std::vector<std::string>& overrides)
  {
    try {
      apps::read_parameter_file(file, overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static coupling::PullOutParameters pull_out(const fs::path& file,
                                              const std::vector<std::string>& overrides = {})
  {
    return std::get<coupling::PullOutParameters>(
        apps::read_parameter_file(file, overrides).parameters);
  }
};
} // namespace

TEST_F(ParameterFile, TemplateIsTheTestOfThePaper)
{
  const auto p = pull_out(write("template.prm", apps::pull_out_template()));
  EXPECT_EQ(p.contact.stone_stiffness, 6e7); // Table 6
  EXPECT_EQ(p.contact.box_stiffness, 6e7);
  EXPECT_EQ(p.geogrid_contact.stiffness, 0); // of the material
  EXPECT_EQ(p.contact.stone_friction, 0.6);
  EXPECT_EQ(p.contact.box_friction, 0);
  EXPECT_EQ(p.geogrid_contact.friction, 0.7);
  EXPECT_TRUE(p.geogrid_contact.ribs_touch_walls);
  EXPECT_EQ(p.stones.count, 41); // section 3
  EXPECT_EQ(p.pull.speed, 0.01); // section 4
  // Short of the paper's 50 mm (Figs. 9-12), where the second transverse rib, 55 mm behind the
  // front wall, would squeeze stones of 38 mm against it.
  EXPECT_EQ(p.pull.distance, 0.035);
  // About 36 kg at 1500 kg/m3 (section 4) fill the box.
  EXPECT_NEAR(p.box.length * p.box.width * p.box.height, 36. / 1500, 1e-4);
  EXPECT_FALSE(p.geogrid.rigid);
  ASSERT_TRUE(p.geogrid.product);
  EXPECT_EQ(p.geogrid.product->pitch_along, 0.065);
  // It says itself what the case says by the product's file.
  const auto named = pull_out(cases / "pullout.prm");
  EXPECT_EQ(p.geogrid.product->name, "SSLA30");
  EXPECT_EQ(p.geogrid.product->along.stiffness_2, named.geogrid.product->along.stiffness_2);
  EXPECT_EQ(p.geogrid.product->junction_thickness, named.geogrid.product->junction_thickness);
}

TEST_F(ParameterFile, QuickCaseIsTheSameTestPulledFaster)
{
  const auto full = pull_out(cases / "pullout.prm");
  const auto quick = pull_out(cases / "quick.prm");
  EXPECT_EQ(quick.pull.speed, 10 * full.pull.speed);
  EXPECT_EQ(quick.pull.distance, 0.02);
  ASSERT_TRUE(quick.geogrid.product && full.geogrid.product);
  EXPECT_EQ(quick.geogrid.product->along.stiffness_2, full.geogrid.product->along.stiffness_2);
  EXPECT_EQ(quick.geogrid_contact.friction, full.geogrid_contact.friction);
}

TEST_F(ParameterFile, TemplatesShowEveryEntry)
{
  for (const apps::Experiment& experiment : apps::experiments()) {
    apps::ExperimentParameters parameters = experiment.defaults;
    coupling::ParameterTable table;
    experiment.declare(table, parameters);
    const auto scanned = apps::scan_parameter_file(write("case.prm", experiment.template_text));
    for (const auto& entry : table.entries())
      EXPECT_TRUE(std::any_of(scanned.assignments.begin(), scanned.assignments.end(),
                              [&](const auto& set) { return set.key() == entry.key(); }))
          << experiment.name << ": " << entry.key();
  }
}

TEST_F(ParameterFile, OverridesWinInTheirOrder)
{
  const auto p =
      pull_out(folder / "base.prm", {"Geogrid/Youngs modulus=1e9", "Gravity = 1.62",
                                     "Geogrid/Youngs modulus=2e9", "Geogrid/Rigid=true"});
  EXPECT_EQ(p.geogrid.youngs_modulus, 2e9);
  EXPECT_EQ(p.gravity, 1.62);
  EXPECT_TRUE(p.geogrid.rigid);
}

TEST_F(ParameterFile, IncludingFileWinsOverTheIncludedOne)
{
  const auto file = write("soft.prm", "# a softer geogrid\ninclude base.prm\n"
                                      "subsection Geogrid\n"
                                      "  set Youngs modulus = 5e8 # a comment\n"
                                      "end\n");
  const auto p = pull_out(file);
  EXPECT_EQ(p.geogrid.youngs_modulus, 5e8);
  EXPECT_EQ(p.geogrid.density, 910);
}

TEST_F(ParameterFile, FolderOfStonesIsRelativeToTheFileThatNamesIt)
{
  fs::create_directories(folder / "scans");
  write("scans/a.stl", "solid");
  const auto file = write("scanned.prm", "include base.prm\nsubsection Stones\n"
                                         "set Folder = scans\nset Length unit = 0.001\nend\n");
  const auto p = pull_out(file);
  EXPECT_EQ(fs::canonical(p.stones.folder), fs::canonical(folder / "scans"));
  EXPECT_TRUE(fs::path(p.stones.folder).is_absolute());
}

// A product's file says what the ribs are; the case may change some of it, and used.prm holds all
// of it.
TEST_F(ParameterFile, ProductIsReadFromItsFileAndChangedByTheCase)
{
  fs::create_directories(folder / "products");
  write("products/mine.prm", "set Experiment = laboratory\nsubsection Product\n"
                             "  set Pitch along = 0.065\n  set Pitch across = 0.06\n"
                             "  set Rib width along = 0.004\n  set Rib thickness along = 0.002\n"
                             "  set Rib width across = 0.004\n  set Rib thickness across = 0.001\n"
                             "  set Youngs modulus along = 4e9\n  set Youngs modulus across = 5e9\n"
                             "  set Poisson ratio = 0.4\n  set Density = 900\nend\n"
                             "subsection Laboratory\n  set Test = modes\nend\n");
  const auto file = write(
      "case.prm", "include base.prm\nsubsection Geogrid\n  set Product = products/mine.prm\n"
                  "  set Pitch along = 0\n  set Pitch across = 0\n  set Rib width = 0\n"
                  "  set Rib thickness = 0\n  set Youngs modulus = 0\n  set Poisson ratio = 0\n"
                  "  set Density = 0\nend\nsubsection Product\n  set Density = 950\nend\n");
  const auto input = apps::read_parameter_file(file, {"Product/Youngs modulus across=6e9"});
  const auto p = std::get<coupling::PullOutParameters>(input.parameters);
  ASSERT_TRUE(p.geogrid.product);
  EXPECT_EQ(p.geogrid.product->pitch_across, 0.06);
  EXPECT_EQ(p.geogrid.product->across.thickness, 0.001);
  EXPECT_EQ(p.geogrid.product->density, 950);
  EXPECT_EQ(p.geogrid.product->along.youngs_modulus, 4e9);
  EXPECT_EQ(p.geogrid.product->across.youngs_modulus, 6e9);
  // It says it all itself: the product's file may be gone.
  fs::remove(folder / "products/mine.prm");
  const auto again = apps::read_parameter_file(write("used.prm", input.used));
  EXPECT_EQ(again.used, input.used);
  EXPECT_FALSE(pull_out(folder / "base.prm").geogrid.product);
}

// A state knows a file by its content: a folder may move, a drawing must not change.
TEST_F(ParameterFile, KeepsTheContentOfInputFilesInMind)
{
  const auto kept = [&](const std::string& name, const std::string& content) {
    fs::create_directories((folder / name).parent_path());
    write(name, content);
    const auto input =
        apps::read_parameter_file(write("lab.prm", apps::laboratory_template()),
                                  {"Laboratory/Lattice file=" + (folder / name).string()});
    for (const coupling::CaseEntry& entry : input.kept)
      if (entry.key == "Laboratory/Lattice file") return entry.value;
    return std::string();
  };
  const std::string drawn = kept("a/mine.msh", "one");
  EXPECT_EQ(drawn.substr(0, 10), "mine.msh (");
  EXPECT_EQ(kept("b/mine.msh", "one"), drawn);
  EXPECT_NE(kept("a/mine.msh", "two"), drawn);
}

TEST_F(ParameterFile, LooksAtEveryNumberOfAList)
{
  const std::string text = complaint(
      cases / "quick.prm", {"Output/Frames at=0.001, 5", "Pull/Distance=9", "Box/Length=12"});
  EXPECT_NE(text.find("It is 5 m, "), std::string::npos) << text;
}

TEST_F(ParameterFile, RefusesRibsThatYieldBelowTheirOwnStiffness)
{
  const std::string text = complaint(cases / "quick.prm", {"Product/Strength along=15000"});
  EXPECT_NE(text.find("Ribs that yield at 15000 N/m cannot carry the 22000 N/m that the stiffness "
                      "says for a strain of 5 %."),
            std::string::npos)
      << text;
}

TEST_F(ParameterFile, LaboratoryIsKnownByItsFormerNameToo)
{
  const auto file = write("product.prm", apps::laboratory_template());
  const auto input = apps::read_parameter_file(file, {"Experiment=geogrid"});
  EXPECT_EQ(input.experiment->name, "laboratory");
  EXPECT_EQ(input.used, apps::read_parameter_file(file, {}).used);

  CLI::App program;
  apps::add_template_command(program);
  testing::internal::CaptureStdout();
  program.parse("template geogrid");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), apps::laboratory_template());
}

TEST_F(ParameterFile, TemplateOfAStudyIsTheStudyOfTheDocuments)
{
  CLI::App program;
  apps::add_template_command(program);
  testing::internal::CaptureStdout();
  program.parse("template study");
  const fs::path file = fs::path(INTERLOCK_SOURCE_DIR) / "cases/studies/quick_flexibility.prm";
  EXPECT_EQ(testing::internal::GetCapturedStdout(), file_text(file));
}

TEST_F(ParameterFile, BenchmarkCasesAreOfTheSameBox)
{
  const fs::path folder = fs::path(INTERLOCK_SOURCE_DIR) / "cases" / "benchmark";
  const auto packing = [&](const char* name) {
    const auto input = apps::read_parameter_file(folder / name);
    EXPECT_EQ(input.experiment->name, "packing");
    return std::get<coupling::PackingParameters>(input.parameters);
  };
  const auto w1 = packing("w1.prm");
  EXPECT_EQ(fs::path(w1.state.file), folder / "w1_settled.json.gz"); // relative to the case
  EXPECT_EQ(w1.state.written, "");
  EXPECT_EQ(w1.contact.normal_stiffness, 1e7);
  EXPECT_NEAR(w1.contact.tangential_ratio, 2. / 3, 1e-15);
  EXPECT_EQ(w1.time.step, 1e-5);
  EXPECT_EQ(fs::path(packing("w2.prm").state.file), folder / "w2_settled.json.gz");
  EXPECT_EQ(packing("w1-fine.prm").state.spheres_per_clump, 550);
  EXPECT_EQ(packing("w1-squeezed.prm").state.squeeze, 0.009);
  EXPECT_TRUE(packing("w1-squeezed.prm").state.hold_still);
}

TEST_F(ParameterFile, UsedParametersGiveTheSameRunAgain)
{
  const auto first = apps::read_parameter_file(folder / "base.prm", {"Pull/Speed=0.0333333333333"});
  const auto again = apps::read_parameter_file(write("used.prm", first.used));
  EXPECT_EQ(again.used, first.used);
  EXPECT_EQ(std::get<coupling::PullOutParameters>(again.parameters).pull.speed, 0.0333333333333);
  EXPECT_NE(first.used.find("# Speed of the front edge of the geogrid. [m/s]"), std::string::npos);
}

// What editors, web pages and other programs put into a file. The value is always the same.
TEST_F(ParameterFile, DialectsOfTextFilesAreRead)
{
  const std::string text = "include base.prm\nsubsection Geogrid\n  set Density = 920\nend\n";
  const auto density = [&](const std::string& name, const std::string& bytes) {
    return pull_out(write(name, bytes)).geogrid.density;
  };
  EXPECT_EQ(density("plain.prm", text), 920);
  EXPECT_EQ(density("mark.prm", "\xEF\xBB\xBF" + text), 920);
  EXPECT_EQ(density("dos.prm", boost::replace_all_copy(text, "\n", "\r\n")), 920);
  EXPECT_EQ(density("old_mac.prm", boost::replace_all_copy(text, "\n", "\r")), 920);
  EXPECT_EQ(density("blank_behind.prm", boost::replace_all_copy(text, "920", "920\u00A0")), 920);
  EXPECT_EQ(density("blank_between.prm", boost::replace_all_copy(text, "set ", "set\u00A0")), 920);
  EXPECT_EQ(density("no_width.prm", boost::replace_all_copy(text, "920", "92\u200B0")), 920);
  EXPECT_EQ(density("goes_on.prm", boost::replace_all_copy(text, "= 920", "= \\\n    920")), 920);
  EXPECT_EQ(density("no_end.prm", text.substr(0, text.size() - 1)), 920);
}

TEST_F(ParameterFile, ValuesInQuotesKeepTheirHash)
{
  write("lab.prm", apps::laboratory_template());
  const auto name = [&](const std::string& value) {
    const auto file = write(
        "named.prm", "include lab.prm\nsubsection Product\n  set Name = " + value + "\nend\n");
    const auto input = apps::read_parameter_file(file);
    const auto again = apps::read_parameter_file(write("used.prm", input.used));
    EXPECT_EQ(again.used, input.used) << value;
    return std::get<coupling::LaboratoryParameters>(again.parameters).product.name;
  };
  EXPECT_EQ(name("\"BX #1100\" # of 2010"), "BX #1100");
  EXPECT_EQ(name("BX \\#1100"), "BX #1100");
  EXPECT_EQ(name("BX1100 # of 2010"), "BX1100");
  const auto typed = apps::read_parameter_file(folder / "lab.prm", {"Product/Name=BX #1100"});
  EXPECT_NE(typed.used.find("set Name = \"BX #1100\"\n"), std::string::npos);
}

TEST_F(ParameterFile, UnusualValuesCanBeAskedFor)
{
  const auto p = pull_out(folder / "base.prm", {"Unusual values=true", "Stones/Density=2.65"});
  EXPECT_EQ(p.stones.density, 2.65);
}

// A hand-picked value of each kind, as its text book has it.
TEST(UsualRanges, HoldWhatIsUsual)
{
  using coupling::why_unusual;
  for (const auto& [key, value] : std::vector<std::pair<std::string, double>>{
           {"Stones/Density", 2650},
           {"Geogrid/Density", 910},
           {"Geogrid/Youngs modulus", 2.4e9},
           {"Contact/Stone stiffness", 6e7},
           {"Contact/Geogrid stiffness", 9.76e8},
           {"Box/Length", 0.4},
           {"Gravity", 1.62},
           {"Gravity", 500},
           {"Pull/Speed", 1e-3 / 60},
           {"Stones/D min", 0},
           {"Measures/Elongation limit", 1e30}}) // has no range
    EXPECT_EQ(why_unusual(key, value, "?"), "") << key;
  EXPECT_NE(why_unusual("Stones/Density", 2.65, "kg/m3").find("2.65 g/cm3 are 2650 kg/m3"),
            std::string::npos);
  EXPECT_NE(why_unusual("Geogrid/Youngs modulus", 2400, "Pa").find("2400 MPa are 2.4e+09 Pa"),
            std::string::npos);
  EXPECT_NE(why_unusual("Box/Length", 160, "m").find("160 mm are 0.16 m"), std::string::npos);
}

// A range of an entry that was renamed would never be looked at; an entry without a range takes any
// slip.
TEST(UsualRanges, AreThoseOfAllPhysicalEntries)
{
  std::set<std::string> known;
  for (const apps::Experiment& experiment : apps::experiments()) {
    coupling::ParameterTable table;
    apps::ExperimentParameters parameters = experiment.defaults;
    experiment.declare(table, parameters);
    for (const coupling::ParameterEntry& entry : table.entries()) {
      known.insert(entry.key());
      if (!entry.unit.empty() && entry.unit != "-" && entry.unit != "%") {
        EXPECT_NE(coupling::usual_range(entry.key()), nullptr) << entry.key();
      }
    }
  }
  const std::set<std::string> options = {"--density", "--d-min", "--r-min", "--bulge"}; // of clump
  for (const std::string& key : coupling::keys_with_usual_range())
    EXPECT_TRUE(known.count(key) == 1 || options.count(key) == 1) << key;
}

TEST(NearestName, ForgivesLettersAndCaseButNotMore)
{
  const std::vector<std::string> known = {"run", "report", "template", "Youngs modulus"};
  EXPECT_EQ(apps::nearest_name("rnu", known), "run");
  EXPECT_EQ(apps::nearest_name("tempalte", known), "template");
  EXPECT_EQ(apps::nearest_name("young's MODULUS", known), "Youngs modulus");
  EXPECT_EQ(apps::nearest_name("density", known), "");
}
