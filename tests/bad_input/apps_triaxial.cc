// Bad parameter files of a triaxial test: each test states one slip and the words that must be in
// the answer. It takes a slip that is accepted, or an answer that does not name entry, value and
// what is allowed, to fail. Also the case itself: its contacts are those of the pull-out, its
// stones those of the pull-out filled to the paper's masses.
#include "apps/case_templates.h"
#include "apps/parameter_file.h"
#include "coupling/output/monitor.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

using namespace interlock;

namespace
{
class BadTriaxial : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("triaxial.prm", apps::triaxial_template());
  }

  // Expects an answer to the case with one change, with the entry and all these words in it.
  void expect(const std::string& change, const std::string& entry,
              const std::vector<std::string>& words) const
  {
    expect_refusal(
        [&] {
          const auto input =
              apps::read_parameter_file(folder / "triaxial.prm", {"Stones/Count=3", change});
          input.experiment->prepare(input.parameters, {});
        },
        entry, words);
  }
};
} // namespace

TEST_F(BadTriaxial, ValuesOutsideTheirRange)
{
  expect("Load/Cell pressure=0", "\"Load/Cell pressure\" is \"0\"",
         {"must be a number greater than 0, in Pa."});
  expect("Load/Cell pressure=30 kPa", "\"Load/Cell pressure\" is \"30 kPa\"", {"in Pa"});
  expect("Compression/Strain rate=0", "\"Compression/Strain rate\" is \"0\"",
         {"a number greater than 0, in 1/s."});
  expect("Compression/Strain=0", "\"Compression/Strain\" is \"0\"", {"0.5"});
  expect("Compression/Strain=15", "\"Compression/Strain\" is \"15\"", {"0.5"});
  expect("Compression/Ramp time=-1", "\"Compression/Ramp time\" is \"-1\"",
         {"a number of 0 or more, in s."});
  expect("Box/Height=-0.3", "\"Box/Height\" is \"-0.3\"", {"a number greater than 0, in m."});
  expect("Filling/Stone friction=-2", "\"Filling/Stone friction\" is \"-2\"",
         {"must be a number from -1 to 5."});
}

TEST_F(BadTriaxial, UnusualUnits)
{
  expect("Load/Cell pressure=30", "Load/Cell pressure",
         {"100 to 1e+07 Pa are usual; 30 kPa are 30000 Pa"});
  expect("Compression/Strain rate=12", "Compression/Strain rate", {"12 %/s are 0.12 1/s"});
}

TEST_F(BadTriaxial, ContradictionsAndUnknownNames)
{
  expect("Compression/Ramp time=4", "Compression/Ramp time",
         {"needs a strain of 0.2 to reach full speed in 4 s", "0.15 only."});
  expect("Load/Compaction stress=5000", "Load/Compaction stress",
         {"The compaction stress is 5000 Pa", "at least the cell pressure, 30000 Pa, or 0"});
  expect("Contact/Stone on box friction=-0.5", "Contact/Stone on box friction", {"-0.5"});
  expect("Compression/Strain rat=1", "\"Compression/Strain rat\"",
         {"the nearest known one is \"Compression/Strain rate\""});
  expect("Load/Normal stress=1e4", "there is no entry \"Load/Normal stress\"",
         {"this section has \"Cell pressure\", \"Compaction stress\"."});
}

// What only the stones can tell.
TEST_F(BadTriaxial, StonesThatDoNotFit)
{
  expect("Box/Width=0.04", "Stone ", {"but the box is only 0.04 m wide."});
}

TEST_F(BadTriaxial, CaseHasTheContactsOfThePullOut)
{
  write("pullout.prm", apps::pull_out_template());
  const auto read = [&](const char* name) {
    return apps::read_parameter_file(folder / name).parameters;
  };
  const auto test = std::get<coupling::TriaxialParameters>(read("triaxial.prm"));
  const auto pull = std::get<coupling::PullOutParameters>(read("pullout.prm"));
  EXPECT_EQ(test.specimen.stones.count, pull.stones.count);
  EXPECT_EQ(test.specimen.stones.density, pull.stones.density);
  EXPECT_EQ(test.specimen.stones.mass_properties, pull.stones.mass_properties);
  EXPECT_EQ(test.specimen.contact.stone_stiffness, pull.contact.stone_stiffness);
  EXPECT_EQ(test.specimen.contact.box_stiffness, pull.contact.box_stiffness);
  EXPECT_EQ(test.specimen.contact.stone_friction, pull.contact.stone_friction);
  EXPECT_EQ(test.specimen.contact.tangential_ratio, pull.contact.tangential_ratio);
  EXPECT_EQ(test.specimen.contact.damping_ratio, pull.contact.damping_ratio);
  EXPECT_EQ(test.specimen.filling.drop_height, pull.filling.drop_height);
  EXPECT_EQ(test.specimen.filling.local_damping, pull.filling.local_damping);
}
