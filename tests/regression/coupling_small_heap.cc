// A small heap: 5 shapes in 4 batches, 12 spheres a clump, from 0.2 m. Checked are laws that every
// run obeys (ledger, mass, reproducible digits, no delayed release, at rest), not numbers
// that the program printed before. Fails when a stage breaks, a digit depends on the run, or energy
// is lost.
#include "coupling/heap/heap.h"
#include "coupling/stones/stone_shapes.h"
#include "tests/run_case.h"
#include "tests/temporary_folder.h"

#include <fstream>

using namespace interlock;
using namespace interlock::coupling;

namespace
{
HeapParameters small_heap(const std::string& mass_properties)
{
  HeapParameters p;
  p.stones.count = 5;
  p.stones.density = 2650;
  p.stones.d_min = 1e-3;
  p.stones.r_min = 3e-3;
  p.stones.p_max = 100;
  p.stones.max_spheres = 12;
  p.stones.mass_properties = mass_properties;
  p.contact.normal_stiffness = 2e6;
  p.contact.tangential_ratio = 1;
  p.contact.stone_friction = 0.7;
  p.contact.floor_friction = 0.5;
  p.contact.model.damping_ratio = 0.3;
  p.contact.local_damping = 0.3;
  p.drop.batches = 4;
  p.drop.height = 0.2;
  p.drop.disc_radius = 0.04;
  p.drop.floor_side = 3;
  p.drop.kinetic_energy_ratio = 1e-4;
  p.drop.settling_time_limit = 3;
  p.measures.radius = 0.2;
  p.measures.elongation_limit = 0.7;
  p.time.safety_factor = 0.8;
  p.output.record_interval = 0.05;
  return p;
}

class SmallHeap : public TemporaryFolderTest
{
};
} // namespace

TEST_F(SmallHeap, ObeysTheLaws)
{
  const Summary s = run_case<Heap>(small_heap("uniform"), folder);
  EXPECT_EQ(s.experiment, "heap");
  EXPECT_EQ(s.clumps, 20);
  EXPECT_EQ(warnings_beside_clumps(s.warnings), std::vector<std::string>());
  EXPECT_LT(s.energy["relative_error"], 0.01);
  EXPECT_GT(s.energy["friction_J"], 0.);
  // All that the stones fell is gone: what is left of the height is that of the heap.
  EXPECT_NEAR(double(s.energy["work_put_in_J"]),
              double(s.energy["friction_J"]) + double(s.energy["contact_damping_J"]) +
                  double(s.energy["local_damping_J"]),
              0.02 * double(s.energy["work_put_in_J"]));
  EXPECT_EQ(s.results["longest_delay_of_a_release_s"], 0.);
  EXPECT_EQ(double(s.results["elongated_stones"]) + double(s.results["other_stones"]), 20);
  EXPECT_LT(s.results["r50_m"], s.results["radius_of_gyration_m"].get<double>() * 1.5);
  EXPECT_GT(s.results["height_m"], 0.);
  for (const char* name : {"history.csv", "stones.csv", "summary.json", "clumps.xdmf"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  std::ifstream table(folder / "stones.csv");
  std::string line;
  int lines = 0;
  while (std::getline(table, line)) ++lines;
  EXPECT_EQ(lines, 21);

  const Summary again = run_case<Heap>(small_heap("uniform"), folder);
  EXPECT_EQ(again.state_hash, s.state_hash);
  const Summary corrected = run_case<Heap>(small_heap("mesh"), folder);
  // The mass properties of the meshes are other ones, of the same volumes, and the stones come to
  // rest elsewhere, by far more than rounding.
  const auto uniform = make_stones(small_heap("uniform").stones, {}),
             mesh = make_stones(small_heap("mesh").stones, {});
  ASSERT_EQ(uniform.size(), 5u);
  ASSERT_EQ(mesh.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const dem::ClumpShape &one = uniform[k].shape, &other = mesh[k].shape;
    EXPECT_NEAR(other.volume, one.volume, 1e-12 * one.volume);
    EXPECT_GT((other.unit_inertia - one.unit_inertia).norm(), 0.01 * one.unit_inertia.norm());
  }
  EXPECT_GT(std::abs(corrected.results["radius_of_gyration_m"].get<double>() -
                     s.results["radius_of_gyration_m"].get<double>()),
            1e-6);
  EXPECT_NEAR(double(corrected.results["mass_kg"]), double(s.results["mass_kg"]), 1e-12);
}
