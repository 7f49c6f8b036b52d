// The stones of a run. It takes a clump in pieces, or one without the volume of its stone, that is not
// warned of, or clumps from files that are not those that were written, to fail.
#include "coupling/parameters/stone_declarations.h"
#include "coupling/stones/stone_quality.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

using namespace interlock;
using coupling::Stone;

namespace
{
coupling::StoneParameters three_stones(double d_min, double r_min, double p_max)
{
  coupling::StoneParameters p;
  p.count = 3;
  p.density = 2650;
  p.d_min = d_min;
  p.r_min = r_min;
  p.p_max = p_max;
  return p;
}

class StonesOfARun : public TemporaryFolderTest
{
};
} // namespace

// The settings of the case loose.prm, and those that it had before.
TEST_F(StonesOfARun, ClumpsInPiecesAreWarnedOf)
{
  const std::vector<Stone> whole = coupling::make_stones(three_stones(1e-3, 1.5e-3, 100), {});
  for (const Stone& stone : whole) EXPECT_EQ(stone.groups, 1);
  EXPECT_EQ(coupling::quality_warnings(whole), std::vector<std::string>());
  EXPECT_NE(coupling::quality_text(whole).find("all in one piece"), std::string::npos);

  const std::vector<Stone> pieces = coupling::make_stones(three_stones(1.5e-3, 1e-3, 2.1), {});
  const auto warnings = coupling::quality_warnings(pieces);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("of 3 clumps are in pieces"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[1].find("volume"), std::string::npos) << warnings[1];
}

TEST_F(StonesOfARun, ClumpsFromFilesAreThoseThatWereWritten)
{
  coupling::StoneParameters p = three_stones(1e-3, 1.5e-3, 100);
  const std::vector<Stone> made = coupling::make_stones(p, {});
  for (const Stone& stone : made)
    dem::write_clump_shape((folder / (stone.shape.name + ".clump.json")).string(), stone.shape);
  p.folder = folder.string();
  coupling::ParameterProblems problems;
  coupling::check_stones(p, problems);
  EXPECT_TRUE(problems.take().empty());
  const std::vector<Stone> read = coupling::make_stones(p, {});
  ASSERT_EQ(read.size(), made.size());
  for (std::size_t k = 0; k < made.size(); ++k) {
    const dem::ClumpShape &a = made[k].shape, &b = read[k].shape;
    EXPECT_EQ(b.name, a.name);
    EXPECT_EQ(b.volume, a.volume);
    EXPECT_EQ(b.unit_inertia, a.unit_inertia);
    ASSERT_EQ(b.spheres.size(), a.spheres.size());
    EXPECT_EQ(b.spheres.back().centre, a.spheres.back().centre);
    EXPECT_EQ(read[k].groups, made[k].groups);
    EXPECT_NEAR(read[k].volume_error, made[k].volume_error, 0.01);
    // Measured on the spheres instead of the scan.
    EXPECT_NEAR(read[k].longest, made[k].longest, 0.1 * made[k].longest);
  }
  write("scan.stl", "solid");
  coupling::check_stones(p, problems);
  EXPECT_EQ(problems.take().size(), 1u); // both kinds in one folder
}
