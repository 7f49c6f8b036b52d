// A whole pull-out in a small box: 12 shapes, a geogrid of 2 x 2 apertures, 2 mm of fast pull.
// Checked are laws that every run obeys (ledger, reproducible digits, mass, overlap, sign of the
// force), not numbers that the program printed before. Fails when a stage breaks, a digit depends
// on the run, or energy is lost.
#include "coupling/pull_out/pull_out.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
PullOutParameters small_case()
{
  PullOutParameters p;
  p.stones.count = 12;
  p.stones.density = 2650;
  p.stones.d_min = 1e-3;
  p.stones.r_min = 2e-3;
  p.stones.p_max = 100;
  p.stones.max_spheres = 40;
  p.box.length = 0.16;
  p.box.width = 0.14;
  p.box.height = 0.12;
  p.box.slot_height = 0.02;
  p.contact.stone_stiffness = p.contact.box_stiffness = 1e7;
  p.contact.geogrid_stiffness = 1e8;
  p.contact.stone_friction = 0.6;
  p.contact.geogrid_friction = 0.7;
  p.contact.tangential_ratio = 1;
  p.contact.damping_ratio = 0.3;
  p.contact.geogrid_damping_ratio = 0.1;
  p.geogrid.placement = "not flattened";
  p.geogrid.apertures_along = p.geogrid.apertures_across = 2;
  p.geogrid.pitch_along = p.geogrid.pitch_across = 0.065;
  p.geogrid.overhang = 5e-3;
  p.geogrid.rib_width = 5e-3;
  p.geogrid.rib_thickness = 2.5e-3;
  p.geogrid.edge_rounding = 5e-4;
  p.geogrid.youngs_modulus = 2.4e9;
  p.geogrid.poisson_ratio = 0.3;
  p.geogrid.density = 910;
  p.geogrid.elements_per_rib = 4;
  p.geogrid.mass_damping = 100;
  p.filling.drop_height = 0.01;
  p.filling.plate_speed = 0.1;
  p.filling.plate_force_limit = 500;
  p.filling.local_damping = 0.5;
  p.filling.kinetic_energy_ratio = 1e-3;
  p.filling.settling_time_limit = 1;
  p.pull.speed = 0.2;
  p.pull.distance = 2e-3;
  p.pull.ramp_time = 2e-3;
  p.time.safety_factor = 0.6;
  p.output.records = 20;
  p.output.field_frames = 1;
  return p;
}

Summary run(const PullOutParameters& parameters, const std::string& name)
{
  const fs::path folder = fs::temp_directory_path() / ("interlock_small_pull_out_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  PullOut pull_out(parameters, {});
  const Summary summary = pull_out.run(folder);
  EXPECT_TRUE(fs::exists(folder / "summary.json"));
  EXPECT_TRUE(fs::exists(folder / "clumps.h5"));
  std::ifstream history(folder / "history.csv");
  int lines = 0;
  for (std::string line; std::getline(history, line);) ++lines;
  EXPECT_GE(lines, 20);
  fs::remove_all(folder);
  return summary;
}

void check_laws(const Summary& s)
{
  EXPECT_LT(s.energy["relative_error"].get<double>(), 0.01);
  EXPECT_LT(s.energy["pull_relative_error"].get<double>(), 0.02);
  EXPECT_LT(s.results["largest_overlap_over_mean_sphere_radius"].get<double>(), 0.02);
  EXPECT_GT(s.results["pull_force_at_end_N"].get<double>(), 0);
  EXPECT_GT(s.energy["pull_clamp_work_J"].get<double>(), 0);
  EXPECT_GT(s.results["bulk_density_kg_per_m3"].get<double>(), 1000);
  EXPECT_LT(s.results["bulk_density_kg_per_m3"].get<double>(), 2000);
  for (const auto& warning : s.warnings) ADD_FAILURE() << warning;
}
} // namespace

TEST(SmallPullOut, FlexibleGeogridTwiceWithTheSameDigits)
{
  const Summary first = run(small_case(), "flexible"), second = run(small_case(), "again");
  check_laws(first);
  EXPECT_GE(first.results["substeps"].get<int>(), 2);
  EXPECT_EQ(first.state_hash, second.state_hash);
  EXPECT_EQ(first.steps, second.steps);
}

TEST(SmallPullOut, RigidGeogridFlattened)
{
  PullOutParameters p = small_case();
  p.geogrid.rigid = true;
  p.geogrid.placement = "flattened";
  p.surcharge.force = 20;
  p.surcharge.sphere_radius = 0.03;
  const Summary s = run(p, "rigid");
  check_laws(s);
  EXPECT_EQ(s.results["substeps"].get<int>(), 1);
}

// The plate follows the stones and presses while the geogrid moves below it. This pull is so abrupt
// that they sink at 8 m/s2; a dead weight would hardly press. Steady motion, where the force is
// kept to 1 %, is in verification/dem_force_control.
TEST(SmallPullOut, PlateKeepsTheSurcharge)
{
  PullOutParameters p = small_case();
  p.surcharge.kind = "plate";
  p.surcharge.force = 100;
  const Summary s = run(p, "plate");
  check_laws(s);
  EXPECT_NEAR(s.results["surcharge_plate_mean_force_N"].get<double>(), 100, 25);
  EXPECT_NEAR(s.results["surcharge_plate_height_at_end_m"].get<double>(), p.box.height, 0.03);
}

TEST(SmallPullOut, AnotherSeedIsAnotherPacking)
{
  PullOutParameters p = small_case();
  const std::uint64_t hash = run(p, "seed_1").state_hash;
  p.filling.seed = 2;
  EXPECT_NE(run(p, "seed_2").state_hash, hash);
}
