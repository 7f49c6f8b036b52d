// A few stones in a box, run as a packed state. It takes a floor that does not carry their weight,
// a contact that the neighbour lists miss, a ledger that does not close, forces that depend on the
// number of spheres inside the same surface, or stones held still that move, to fail.
#include "coupling/packing/packing.h"
#include "dem/input_error.h"
#include "tests/packed_plates.h"
#include "tests/run_case.h"
#include "tests/temporary_folder.h"

#include <sstream>

using namespace interlock;
using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
class SmallPacking : public TemporaryFolderTest
{
protected:
  PackingParameters parameters(int plates) const
  {
    write_packed_state(folder / "plates.json.gz", packed_plates(plates));
    PackingParameters p;
    p.gravity = 9.81;
    p.state.file = (folder / "plates.json.gz").string();
    p.contact = {1e6, 2. / 3, 0.7, 4000, 2000};
    p.time = {1e-5, 0.2};
    p.warm_up_steps = 10000;
    p.timed_steps = 1000;
    p.records = 10;
    return p;
  }

  Summary run(const PackingParameters& p) const { return run_case<Packing>(p, folder); }

  static double result(const Summary& summary, const char* name)
  {
    return summary.results[name].get<double>();
  }
};
} // namespace

TEST_F(SmallPacking, FloorCarriesTheWeight)
{
  PackingParameters p = parameters(3);
  p.state.missed_contact_checks = 5;
  const Summary s = run(p);
  EXPECT_NEAR(result(s, "weight_N"), 3 * 0.035 * 9.81, 1e-9);
  EXPECT_NEAR(result(s, "carried_weight_over_weight"), 1, 1e-3);
  // Four feet a plate, on the floor and on the plate below.
  EXPECT_EQ(result(s, "wall_contacts"), 4);
  EXPECT_EQ(result(s, "touching_sphere_pairs"), 8);
  EXPECT_EQ(result(s, "touching_clump_pairs"), 2);
  // The lowest feet carry a quarter of the weight each.
  EXPECT_NEAR(result(s, "largest_overlap_m"), result(s, "weight_N") / 4 / 1e6, 1e-9);
  EXPECT_LT(s.energy["relative_error"].get<double>(), 0.01);
  EXPECT_TRUE(s.warnings.empty()) << s.warnings.front();

  std::ifstream history(folder / "history.csv");
  int lines = 0;
  for (std::string line; std::getline(history, line);) ++lines;
  EXPECT_EQ(lines, 1 + p.records);
  EXPECT_TRUE(fs::exists(folder / "summary.json"));
  EXPECT_EQ(s.steps, 11000);
  EXPECT_EQ(result(s, "timed_steps"), 990); // ten have a record, five of these a check besides
}

TEST_F(SmallPacking, ThrownStonesLoseNoContactAndNoEnergy)
{
  PackingParameters p = parameters(3);
  p.state.throw_speed = 0.3;
  p.state.throw_spin = 12;
  p.state.missed_contact_checks = 50;
  p.warm_up_steps = 0;
  p.timed_steps = 5000;
  const Summary s = run(p);
  EXPECT_LT(s.energy["relative_error"].get<double>(), 0.01);
  EXPECT_EQ(run(p).state_hash, s.state_hash);
  p.state.seed = 2;
  EXPECT_NE(run(p).state_hash, s.state_hash);
}

// Skins are a matter of speed alone.
TEST_F(SmallPacking, SkinsChangeNoDigit)
{
  PackingParameters p = parameters(3);
  p.state.throw_speed = 0.3;
  p.state.throw_spin = 12;
  p.warm_up_steps = 0;
  const std::uint64_t hash = run(p).state_hash;
  p.lists = {1e-5, 1e-4};
  EXPECT_EQ(run(p).state_hash, hash);
  p.lists = {1e-4, 2e-3};
  EXPECT_EQ(run(p).state_hash, hash);
}

// The written state is the one that runs: refined and squeezed.
TEST_F(SmallPacking, WrittenStateIsTheStateBeforeTheFirstStep)
{
  PackingParameters p = parameters(2);
  p.warm_up_steps = 0;
  p.timed_steps = 40;
  p.state.spheres_per_clump = 30;
  p.state.squeeze = 0.02;
  p.state.written = (folder / "written.json").string();
  const Summary s = run(p);
  EXPECT_EQ(s.spheres, 60);
  const PackedState written = read_packed_state(folder / "written.json");
  EXPECT_EQ(written.shapes[0].spheres.size(), 30u);
  EXPECT_NEAR(written.clumps[1].position.z(), 0.98 * 0.0302, 1e-15);

  PackingParameters again = p;
  again.state = {};
  again.state.file = p.state.written;
  const Summary t = run(again);
  EXPECT_EQ(t.contacts, s.contacts);
  EXPECT_NEAR(result(t, "floor_force_N"), result(s, "floor_force_N"),
              1e-9 * result(s, "floor_force_N"));
}

TEST_F(SmallPacking, StonesHeldStillKeepTheirForces)
{
  PackingParameters p = parameters(2);
  p.state.squeeze = 0.02;
  p.state.hold_still = true;
  p.warm_up_steps = 100;
  p.timed_steps = 100;
  const Summary s = run(p);
  EXPECT_NEAR(result(s, "largest_overlap_m"), 0.02 - 0.98 * 0.0201, 1e-12); // of the two plates
  // Four feet on the floor.
  EXPECT_NEAR(result(s, "floor_force_N"), 4 * 1e6 * (0.01 - 0.98 * 0.0101), 1e-6);
  EXPECT_EQ(result(s, "touching_sphere_pairs"), 4);
  // However long: no digit of what depends on poses and springs moves.
  p.timed_steps = 200;
  const Summary longer = run(p);
  EXPECT_EQ(result(longer, "largest_overlap_m"), result(s, "largest_overlap_m"));
  EXPECT_NEAR(result(longer, "floor_force_N"), result(s, "floor_force_N"), 1e-9); // means
  EXPECT_EQ(result(longer, "kinetic_energy_J"), 0);
  EXPECT_EQ(longer.steps, s.steps + 100);
}

TEST_F(SmallPacking, UnusableParametersAreOneSentence)
{
  const auto refusal = [](const PackingParameters& p) -> std::string {
    try {
      Packing packing(p);
      packing.prepare({}, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  PackingParameters p = parameters(1);
  p.time.step = 1;
  EXPECT_NE(refusal(p).find("Time/Step"), std::string::npos);
  p = parameters(1);
  p.state.spheres_per_clump = 3;
  EXPECT_NE(refusal(p).find("Packing/Spheres per clump is 3"), std::string::npos) << refusal(p);
}
