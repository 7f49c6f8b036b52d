// Bad parameter files of a shear box: each test states one slip and the words that must be in the
// answer. It takes a slip that is accepted, or an answer that does not name entry, value and what
// is allowed, to fail. Also the case itself: its stones and contacts are those of the pull-out.
#include "apps/case_templates.h"
#include "apps/parameter_file.h"
#include "coupling/output/monitor.h"
#include "dem/input_error.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace interlock;

namespace
{
class BadShearBox : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("shear_box.prm", apps::shear_box_template());
  }

  // Expects an answer to the case with one change, with all these words in it: one sentence, where
  // it is but one slip.
  void expect(const std::string& change, const std::vector<std::string>& words,
              bool one_slip = true) const
  {
    try {
      const apps::RunInput input =
          apps::read_parameter_file(folder / "shear_box.prm", {"Stones/Count=3", change});
      input.experiment->prepare(input.parameters, {});
      ADD_FAILURE() << change << " was accepted";
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_TRUE(!one_slip || text.find('\n') == std::string::npos) << text;
      EXPECT_EQ(text.back(), '.');
      for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" in: " << text;
    }
  }
};
} // namespace

TEST_F(BadShearBox, ValuesOutsideTheirRange)
{
  expect("Load/Normal stress=0",
         {"\"Load/Normal stress\" is \"0\"", "must be a number greater than 0, in Pa."});
  expect("Load/Normal stress=35 kPa", {"\"Load/Normal stress\" is \"35 kPa\"", "in Pa"});
  expect("Box/Gap=-0.01", {"\"Box/Gap\" is \"-0.01\"", "must be a number of 0 or more, in m."});
  expect("Shear/Speed=0", {"\"Shear/Speed\" is \"0\"", "a number greater than 0, in m/s."});
  expect("Shear/Distance=-1", {"\"Shear/Distance\" is \"-1\"", "a number greater than 0, in m."});
  expect("Filling/Stone friction=-2",
         {"\"Filling/Stone friction\" is \"-2\"", "must be a number from -1 to 5."});
}

// Another unit contradicts the other entries, too.
TEST_F(BadShearBox, UnusualUnits)
{
  expect("Load/Normal stress=35",
         {"Load/Normal stress", "100 to 1e+07 Pa are usual; 35 kPa are 35000 Pa"}, false);
  expect("Shear/Speed=30", {"Shear/Speed", "30 mm/s are 0.03 m/s"}, false);
}

TEST_F(BadShearBox, ContradictionsAndUnknownNames)
{
  expect("Load/Normal stress=1000",
         {"The normal stress is 1000 Pa", "the upper half alone press with", "Box/Height"});
  expect("Box/Gap=0.1",
         {"The gap is 0.1 m wide", "smaller than half the height of the box, 0.1 m."});
  expect("Shear/Distance=0.2", {"moves by 0.2 m", "at most half the length of the box, 0.15 m."});
  expect("Shear/Ramp time=4", {"needs 0.06 m to reach full speed in 4 s", "0.03 m only."});
  expect("Load/Compaction stress=5000",
         {"The compaction stress is 5000 Pa", "at least the normal stress, 10000 Pa, or 0"});
  expect("Box/Floor and plate friction=-0.5", {"It is -0.5", "must be 0 or more, or -1"});
  expect("Shear/Sped=1", {"\"Shear/Sped\"", "the nearest known one is \"Shear/Speed\""});
  expect("Pull/Distance=0.1", {"there is no entry \"Pull/Distance\""});
}

// What only the stones can tell.
TEST_F(BadShearBox, StonesThatDoNotFit)
{
  expect("Box/Width=0.04", {"Stone ", "but the box is only 0.04 m wide."});
  expect("Box/Gap=0.04", {"Box/Gap is 0.04 m", "at most half the size of the smallest stone"});
}

TEST_F(BadShearBox, CaseHasTheStonesAndContactsOfThePullOut)
{
  const std::filesystem::path cases = std::filesystem::path(INTERLOCK_SOURCE_DIR) / "cases";
  const auto shear = std::get<coupling::ShearBoxParameters>(
      apps::read_parameter_file(cases / "ballast/shear_box.prm").parameters);
  const auto pull = std::get<coupling::PullOutParameters>(
      apps::read_parameter_file(cases / "pullout/pullout.prm").parameters);
  EXPECT_EQ(shear.specimen.stones.count, pull.stones.count);
  EXPECT_EQ(shear.specimen.stones.density, pull.stones.density);
  EXPECT_EQ(shear.specimen.stones.d_min, pull.stones.d_min);
  EXPECT_EQ(shear.specimen.stones.r_min, pull.stones.r_min);
  EXPECT_EQ(shear.specimen.stones.max_spheres, pull.stones.max_spheres);
  EXPECT_EQ(shear.specimen.stones.sphere_order, pull.stones.sphere_order);
  EXPECT_EQ(shear.specimen.stones.bulge, pull.stones.bulge);
  EXPECT_EQ(shear.specimen.stones.mass_properties, pull.stones.mass_properties);
  EXPECT_EQ(shear.specimen.contact.stone_stiffness, pull.contact.stone_stiffness);
  EXPECT_EQ(shear.specimen.contact.box_stiffness, pull.contact.box_stiffness);
  EXPECT_EQ(shear.specimen.contact.stone_friction, pull.contact.stone_friction);
  EXPECT_EQ(shear.specimen.contact.box_friction, pull.contact.box_friction);
  EXPECT_EQ(shear.specimen.contact.tangential_ratio, pull.contact.tangential_ratio);
  EXPECT_EQ(shear.specimen.contact.damping_ratio, pull.contact.damping_ratio);
  EXPECT_EQ(shear.specimen.filling.drop_height, pull.filling.drop_height);
  EXPECT_EQ(shear.specimen.filling.local_damping, pull.filling.local_damping);
}
