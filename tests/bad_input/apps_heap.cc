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

// Entry, value and what is allowed, each in the words of the answer: a number alone, or the letter
// of a unit, is in almost any sentence.
TEST_F(BadHeap, ValuesOutsideTheirRange)
{
  expect("Drop/Batches=0",
         {"\"Drop/Batches\" is \"0\"", "must be a whole number from 1 to 10000."});
  expect("Drop/Batches=2.5", {"\"Drop/Batches\" is \"2.5\"", "a whole number from 1 to 10000."});
  expect("Drop/Height=-1", {"\"Drop/Height\" is \"-1\"", "must be a number greater than 0, in m."});
  expect("Drop/Disc radius=10 mm",
         {"\"Drop/Disc radius\" is \"10 mm\"", "without their unit", "in m (here 0.01)."});
  expect("Gravity=0", {"\"Gravity\" is \"0\"", "a number greater than 0, in m/s2."});
  expect("Contact/Stone friction=-0.1",
         {"\"Contact/Stone friction\" is \"-0.1\"", "must be a number from 0 to 5."});
  expect("Contact/Damping ratio=1.5",
         {"\"Contact/Damping ratio\" is \"1.5\"", "must be a number from 0 to 1."});
  expect("Contact/Local damping=-0.1",
         {"\"Contact/Local damping\" is \"-0.1\"", "must be a number from 0 to 1."});
  expect("Measures/Elongation limit=1.2",
         {"\"Measures/Elongation limit\" is \"1.2\"", "must be a number from 0 to 1."});
  expect("Stones/Mass properties=corrected",
         {"\"Stones/Mass properties\" is \"corrected\"", "\"equal-mass\"", "\"mesh\""});
  expect("Output/Record interval=0",
         {"\"Output/Record interval\" is \"0\"", "a number greater than 0, in s."});
}

TEST_F(BadHeap, ContradictionsAndUnknownNames)
{
  expect("Drop/Disc radius=3", {"The disc from which the stones fall has a radius of 3 m",
                                "smaller than half the side of the floor, 3 m."});
  expect("Stones/D min=-1", {"\"Stones/D min\" is \"-1\"", "a number of 0 or more, in m."});
  expect("Drop/Hight=2", {"\"Drop/Hight\"", "the nearest known one is \"Drop/Height\""});
  expect("Pull/Speed=1", {"there is no entry \"Pull/Speed\""});
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
