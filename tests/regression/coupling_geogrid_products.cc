// Pull-outs of product geogrids in a small box. Fails when the ribs of a product give other digits
// than the same ribs by entries, when a run with ribs that soften and yield does not close its
// ledger or loses no plastic work, or when a product cannot be
// rigid.
#include "coupling/pull_out/pull_out.h"
#include "tests/geogrid_products.h"
#include "tests/run_case.h"
#include "tests/small_pull_out_case.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
PullOutParameters tiny_case()
{
  PullOutParameters p = small_pull_out_case();
  p.stones.count = 6;
  p.stones.d_min = 2e-3, p.stones.r_min = 3e-3;
  p.stones.max_spheres = 20;
  p.contact.stone_stiffness = p.contact.box_stiffness = 2e6;
  p.geogrid_contact.stiffness = 2e7;
  p.pull.distance = 1e-3;
  p.pull.ramp_time = 1e-3;
  p.output.records = 20;
  return p;
}

PullOutParameters with_product(const ProductParameters& product, int along, int across)
{
  PullOutParameters p = tiny_case();
  GeogridParameters g = test_products::of(product, along, across);
  g.placement = p.geogrid.placement;
  p.geogrid = g;
  return p;
}

// What is left in the folder is looked at by `look`.
template <class Look> Summary run(const PullOutParameters& p, const Look& look)
{
  const fs::path folder =
      fs::temp_directory_path() / ("interlock_geogrid_products_" + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  const Summary summary = run_case<PullOut>(p, folder);
  look(folder);
  fs::remove_all(folder);
  return summary;
}

Summary run(const PullOutParameters& p)
{
  return run(p, [](const fs::path&) {});
}

double energy(const Summary& s, const char* name)
{
  return s.energy[name].template get<double>();
}
} // namespace

TEST(GeogridProducts, SameRibsByEntriesHaveTheSameDigits)
{
  const PullOutParameters entries = tiny_case();
  ProductParameters same;
  same.pitch_along = same.pitch_across = entries.geogrid.pitch_along;
  same.along = {entries.geogrid.rib_width, entries.geogrid.rib_thickness,
                entries.geogrid.youngs_modulus};
  same.across = same.along;
  same.poisson_ratio = entries.geogrid.poisson_ratio;
  same.density = entries.geogrid.density;
  same.elements_per_rib = entries.geogrid.elements_per_rib;
  const Summary by_entries = run(entries), by_product = run(with_product(same, 2, 2));
  EXPECT_EQ(by_entries.state_hash, by_product.state_hash);
  EXPECT_EQ(by_entries.steps, by_product.steps);
  EXPECT_EQ(energy(by_product, "geogrid_plastic_J"), 0);
}

// Ribs a three-hundredth as strong as those of the library yield in this box.
TEST(GeogridProducts, TrianglesThatSoftenAndYieldCloseTheLedger)
{
  ProductParameters weak = test_products::triaxial();
  for (auto* ribs : {&weak.along, &weak.across}) {
    ribs->youngs_modulus = 0;
    ribs->stiffness_2 = 2e3;
    ribs->stiffness_5 = 1.6e3;
    ribs->strength = 100;
  }
  weak.junction_reach = 0.003, weak.junction_thickness = 0.0031;
  weak.elements_per_rib = 6;
  PullOutParameters p = with_product(weak, 3, 2);
  p.geogrid.cut_width = 0.13;
  const Summary s = run(p, [](const fs::path& folder) {
    std::ifstream history(folder / "history.csv");
    std::string columns;
    std::getline(history, columns);
    EXPECT_NE(columns.find("transverse_rib_3_load [N]"), std::string::npos); // rows 0 to 3
    EXPECT_EQ(columns.find("transverse_rib_4_load [N]"), std::string::npos);
    EXPECT_NE(columns.find("geogrid_plastic"), std::string::npos);
  });
  EXPECT_GT(energy(s, "geogrid_plastic_J"), 0);
  EXPECT_LT(energy(s, "relative_error"), 0.01);
  EXPECT_LT(energy(s, "pull_relative_error"), 0.02);
}

TEST(GeogridProducts, CanBeRigid)
{
  ProductParameters product = test_products::softening();
  product.junction_reach = 0.005, product.junction_thickness = 0.007;
  PullOutParameters p = with_product(product, 2, 2);
  p.geogrid.rigid = true;
  const Summary s = run(p);
  EXPECT_EQ(s.results["substeps"].get<int>(), 1);
  EXPECT_NEAR(energy(s, "geogrid_plastic_J"), 0, 1e-20); // rounding of its positions
  EXPECT_LT(energy(s, "relative_error"), 0.01);
}
