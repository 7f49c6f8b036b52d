// Products and lattice files of a pull-out that cannot be used. Each test states one slip and the
// words that must be in the answer. It takes a fault that is not found, or a sentence that does not
// say where it is and what to write instead, to fail.
#include "apps/parameter_file.h"
#include "dem/input_error.h"
#include "tests/pull_out_text.h"
#include "tests/temporary_folder.h"

#include <boost/algorithm/string.hpp>
#include <gtest/gtest.h>

using namespace interlock;
namespace fs = std::filesystem;

namespace
{
const std::string products = std::string(INTERLOCK_SOURCE_DIR) + "/cases/geogrids/";

class BadProduct : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("entries.prm", pull_out_by_entries());
    // Nothing is left of the entries that a product replaces.
    std::string text = pull_out_by_entries();
    for (const std::string entry : {"Pitch along", "Pitch across", "Rib width", "Rib thickness",
                                    "Youngs modulus", "Poisson ratio"}) {
      const auto begin = text.find("  set " + entry, text.find("subsection Geogrid"));
      text.erase(begin, text.find('\n', begin) + 1 - begin);
    }
    const auto density = text.find("  set Density", text.find("subsection Geogrid"));
    text.erase(density, text.find('\n', density) + 1 - density);
    write("good.prm", text);
  }

  static std::string errors(const fs::path& file, const std::vector<std::string>& overrides)
  {
    try {
      const apps::RunInput input = apps::read_parameter_file(file, overrides);
      input.experiment->prepare(input.parameters, {});
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "the input was accepted";
    return "";
  }

  void expect_words(const std::vector<std::string>& overrides,
                    const std::vector<std::string>& words,
                    const std::string& file = "good.prm") const
  {
    const std::string sentence = errors(folder / file, overrides);
    EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0) << sentence;
    for (const std::string& word : words)
      EXPECT_NE(sentence.find(word), std::string::npos) << '"' << word << "\" in: " << sentence;
    EXPECT_EQ(sentence.back(), '.');
  }
};
} // namespace

TEST_F(BadProduct, MissingFileIsNamed)
{
  expect_words({"Geogrid/Product=ssla31.prm"},
               {"--set", "\"Geogrid/Product\"", "ssla31.prm", "does not exist", "cases/geogrids"});
  expect_words({"Geogrid/Product=nowhere/ssla30.prm"},
               {"--set", "\"Geogrid/Product\"", "nowhere/ssla30.prm", "does not exist"});
}

TEST_F(BadProduct, FileWithoutTheSectionIsNoProduct)
{
  write("heap.prm", "set Experiment = heap\n");
  expect_words({"Geogrid/Product=" + (folder / "heap.prm").string()},
               {"heap.prm", "is no product", "section \"Product\""});
}

TEST_F(BadProduct, MistakesInItsFileAreNamedThere)
{
  write("mine.prm", "subsection Product\n  set Pitch alog = 0.065\nend\n");
  const std::string sentences =
      errors(folder / "good.prm", {"Geogrid/Product=" + (folder / "mine.prm").string()});
  EXPECT_NE(sentences.find("mine.prm, line 2"), std::string::npos) << sentences;
  EXPECT_NE(sentences.find("\"Product/Pitch along\""), std::string::npos) << sentences;
}

TEST_F(BadProduct, EntriesThatItReplacesContradictIt)
{
  const std::string product = "Geogrid/Product=" + products + "ss30.prm";
  const std::vector<std::string> apertures = {"Geogrid/Apertures along=9",
                                              "Geogrid/Apertures across=4"};
  expect_words({product, apertures[0], apertures[1], "Geogrid/Rib width=0.005"},
               {"\"Geogrid/Rib width\"", "0.005", "section Product", "set it to 0"});
  expect_words({product, apertures[0], apertures[1], "Geogrid/Elements per rib=4"},
               {"\"Geogrid/Elements per rib\"", "4", "set it to 8"});
}

TEST_F(BadProduct, WithoutItZeroIsNoSize)
{
  expect_words({"Geogrid/Rib thickness=0"},
               {"\"Geogrid/Rib thickness\"", "greater than 0", "Geogrid/Product"}, "entries.prm");
}

TEST_F(BadProduct, PatternThatDoesNotFitTheBoxIsMeasured)
{
  expect_words({"Geogrid/Product=" + products + "tx160.prm", "Geogrid/Apertures along=9",
                "Geogrid/Apertures across=5"},
               {"\"Geogrid/Apertures across\"", "0.2 m wide"});
  expect_words({"Geogrid/Product=" + products + "tx160.prm", "Geogrid/Apertures along=9",
                "Geogrid/Apertures across=4", "Geogrid/Cut width=0.25"},
               {"\"Geogrid/Cut width\"", "0.25", "room for another"});
}

TEST_F(BadProduct, RibsWiderThanTheirApertureOverlap)
{
  expect_words({"Geogrid/Product=" + products + "ss30.prm", "Geogrid/Apertures along=9",
                "Geogrid/Apertures across=4", "Product/Rib width along=0.04"},
               {"\"Product/Rib width along\"", "0.04", "overlap"});
}

TEST_F(BadProduct, JunctionsMustBeRigid)
{
  expect_words({"Geogrid/Product=" + products + "ss30.prm", "Geogrid/Apertures along=9",
                "Geogrid/Apertures across=4", "Product/Junction stiffness=0.3"},
               {"\"Product/Junction stiffness\"", "0.3 N m/rad", "set it to 0"});
}

TEST_F(BadProduct, NodesMustPassTheSlot)
{
  expect_words({"Geogrid/Product=" + products + "ss30.prm", "Geogrid/Apertures along=9",
                "Geogrid/Apertures across=4", "Box/Slot height=0.004"},
               {"\"Box/Slot height\"", "0.004", "0.005"});
}

TEST_F(BadProduct, LatticeFileMustBeALattice)
{
  const std::string file = (folder / "none.msh").string();
  expect_words({"Geogrid/Lattice file=" + file}, {"none.msh"}, "entries.prm");
  expect_words({"Geogrid/Lattice file=" + file, "Geogrid/Cut width=0.2"},
               {"\"Geogrid/Cut width\"", "set it to 0"}, "entries.prm");
}
