// Halves of a small box that are weighed in and pressed level. Fails when the mass is another one
// than asked for, when the plate stops above its height without a warning, when stones keep the
// friction of the filling for the pull, or when mass, volumes and porosities contradict each other.
#include "coupling/stones/filled_box.h"
#include "tests/run_case.h"
#include "tests/small_pull_out_case.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace interlock;
using namespace interlock::coupling;

namespace
{
PullOutParameters small_box()
{
  PullOutParameters p = small_pull_out_case();
  p.stones.max_spheres = 20;
  p.stones.sphere_order = "gain";
  p.stones.bulge = 2e-3;
  p.box.height = 0.16;
  p.geogrid_contact.stiffness = 1e7;
  p.geogrid.placement = "flattened";
  p.filling.stone_friction = 0;
  p.filling.lower_bulk_density = p.filling.upper_bulk_density = 1300;
  p.filling.plate_speed = 0.2;
  p.filling.plate_force_limit = 5000;
  p.pull = {0.2, 5e-4, 1e-3};
  p.output.records = 5;
  p.output.field_frames = 0;
  return p;
}

double largest_stone(const dem::Clumps& clumps)
{
  double largest = 0;
  for (int i = 0; i < clumps.size(); ++i) largest = std::max(largest, clumps.mass[i]);
  return largest;
}

bool warns_of_height(const Summary& summary)
{
  for (const std::string& warning : summary.warnings)
    if (warning.find("The plate stopped at") != std::string::npos) return true;
  return false;
}

struct Filled {
  Summary summary;
  double largest_stone = 0, friction = 0;
};

Filled run(const PullOutParameters& p, const std::filesystem::path& folder)
{
  PullOut experiment(p);
  RunRequest request;
  request.folder = folder;
  request.checkpoint_interval = 0;
  experiment.prepare(request.monitor, {});
  EXPECT_EQ(experiment.world().engine.stone_contact().friction,
            p.filling.stone_friction >= 0 ? p.filling.stone_friction : p.contact.stone_friction);
  Filled filled;
  filled.summary = Run<PullOut>(experiment, request).run();
  filled.largest_stone = largest_stone(experiment.world().engine.clumps());
  filled.friction = experiment.world().engine.stone_contact().friction;
  return filled;
}

class WeighedFilling : public TemporaryFolderTest
{
};
} // namespace

TEST_F(WeighedFilling, MassIsThatAskedForAndTheSurfaceIsLevel)
{
  const PullOutParameters p = small_box();
  const Filled filled = run(p, folder);
  const auto& results = filled.summary.results;
  const auto value = [&](const char* name) { return results.at(name).get<double>(); };
  const double half = 1300 * p.box.length * p.box.width * p.box.height / 2;
  const double mass = value("mass_in_box_kg"), poured = value("mass_poured_on_geogrid_kg");
  EXPECT_NEAR(poured, half, filled.largest_stone);
  // Less what stood in the way of ribs: a layer of two stones springs back from the plate.
  EXPECT_LT(mass - poured, half + filled.largest_stone);
  EXPECT_GT(mass - poured, 0.6 * half);
  EXPECT_NEAR(value("mass_below_geogrid_kg") + value("mass_above_geogrid_kg"), mass, 1e-12);
  EXPECT_FALSE(warns_of_height(filled.summary));
  // How flat it is in a box of the usual size: cases/pullout/filling.py.
  EXPECT_LE(value("geogrid_largest_sag_m"), value("geogrid_largest_deviation_m"));
  EXPECT_LE(value("geogrid_rms_deviation_m"), value("geogrid_largest_deviation_m"));
  EXPECT_EQ(filled.friction, p.contact.stone_friction);
  // By definition: the stones' own volume is their mass over their density.
  EXPECT_NEAR(value("porosity_of_stones"), 1 - value("bulk_density_kg_per_m3") / p.stones.density,
              1e-9);
  // The bulge gives the clumps the volume of their stones, to the statistical error of the union.
  EXPECT_NEAR(value("porosity_of_clumps"), value("porosity_of_stones"), 0.01);
}

// More than the plate can press in: the run says so, and with the entry that limits it.
TEST_F(WeighedFilling, APlateThatStopsTooHighIsSpokenOf)
{
  PullOutParameters p = small_box();
  p.filling.stone_friction = -1;
  p.filling.lower_bulk_density = 1800;
  p.filling.plate_force_limit = 20;
  EXPECT_TRUE(warns_of_height(run(p, folder).summary));
}

// Two spheres and their masses: closed forms.
TEST_F(WeighedFilling, SolidVolumesAreThoseOfStonesAndOfTheirSpheres)
{
  const double radius = 0.01;
  dem::ClumpShape half_missing;
  half_missing.spheres = {{dem::Vector3::Zero(), radius}};
  half_missing.volume = 2 * 4 * M_PI / 3 * std::pow(radius, 3);
  half_missing.unit_inertia = dem::Vector3::Constant(0.4 * half_missing.volume * radius * radius);
  dem::Clumps clumps({});
  const int shape = clumps.add_shape(half_missing);
  for (const double x : {0.02, 0.05, -0.02}) // the last one outside
    clumps.add(shape, 2650, {x, 0.05, 0.05}, dem::Quaternion::Identity());
  const SolidVolumes solid = solid_volumes(clumps, {0.1, 0.1, 0.1, 0.01});
  EXPECT_NEAR(solid.stones, 2 * half_missing.volume, 1e-15);
  EXPECT_NEAR(solid.clumps, half_missing.volume, 0.01 * half_missing.volume);
  EXPECT_NEAR(mass_since(clumps, {0.1, 0.1, 0.1, 0.01}, 1), 2650 * half_missing.volume, 1e-12);
}
