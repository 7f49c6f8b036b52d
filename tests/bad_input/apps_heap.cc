// Bad parameter files of a heap: each test states one slip and the words that must be in the
// answer. It takes a slip that is accepted, or an answer that does not name entry, value and what
// is allowed, to fail. Also the case itself, against the numbers of its paper.
#include "apps/case_templates.h"
#include "apps/parameter_file.h"
#include "dem/input_error.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

using namespace interlock;

namespace
{
class BadHeap : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("heap.prm", apps::heap_template());
  }

  // Expects one sentence about the case with one change, with all these words in it.
  void expect(const std::string& change, const std::vector<std::string>& words) const
  {
    try {
      apps::read_parameter_file(folder / "heap.prm", {change});
      ADD_FAILURE() << change << " was accepted";
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      EXPECT_EQ(text.back(), '.');
      for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" in: " << text;
    }
  }
};
} // namespace

TEST_F(BadHeap, ValuesOutsideTheirRange)
{
  expect("Drop/Batches=0", {"Batches", "0", "1"});
  expect("Drop/Batches=2.5", {"Batches", "2.5", "whole number"});
  expect("Drop/Height=-1", {"Height", "-1", "greater than 0", "m"});
  expect("Drop/Disc radius=10 mm", {"Disc radius", "10 mm"});
  expect("Gravity=0", {"Gravity", "0", "greater than 0"});
  expect("Contact/Stone friction=-0.1", {"Stone friction", "-0.1"});
  expect("Contact/Damping ratio=1.5", {"Damping ratio", "1.5", "from 0 to 1"});
  expect("Contact/Local damping=-0.1", {"Local damping", "-0.1", "from 0 to 1"});
  expect("Measures/Elongation limit=1.2", {"Elongation limit", "1.2", "from 0 to 1"});
  expect("Stones/Mass properties=corrected",
         {"Mass properties", "corrected", "\"equal-mass\"", "\"mesh\""});
  expect("Output/Record interval=0", {"Record interval", "0", "greater than 0"});
}

TEST_F(BadHeap, ContradictionsAndUnknownNames)
{
  expect("Drop/Disc radius=3", {"Drop/Disc radius", "3 m", "half the side of the floor"});
  expect("Stones/D min=-1", {"D min", "-1", "0 or more"});
  expect("Drop/Hight=2", {"Drop/Hight", "Drop/Height"});
  expect("Pull/Speed=1", {"Pull/Speed"});
}

TEST_F(BadHeap, CaseIsTheTestOfThePaper)
{
  const auto input = apps::read_parameter_file(folder / "heap.prm");
  ASSERT_EQ(input.experiment->name, "heap");
  const auto p = std::get<coupling::HeapParameters>(input.parameters);
  EXPECT_EQ(p.stones.count, 41);
  EXPECT_EQ(p.drop.batches, 10);
  EXPECT_EQ(p.drop.height, 1);
  EXPECT_EQ(p.contact.normal_stiffness, 1e7);
  EXPECT_EQ(p.contact.stone_friction, 0.7);
  EXPECT_EQ(p.contact.floor_friction, 0.5);
}
