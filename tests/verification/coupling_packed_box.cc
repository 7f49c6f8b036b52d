// The packed box of cases/benchmark/w1.prm beside LAMMPS (29 Sep 2021, fix rigid/small with
// gran/hooke/history), which counts 881 touching sphere pairs after 2,500 steps from the same state
// with the same law. It takes more than 3 % another number, a floor and side walls that carry
// another weight than that of the stones (0.1 %), a contact that the neighbour lists miss, or a
// ledger that does not close, to fail. The springs of friction are not stored in the state, so the
// count is that of a packing that finds its rest anew.
#include "coupling/packing/packing.h"
#include "tests/run_case.h"
#include "tests/temporary_folder.h"

using namespace interlock::coupling;

using PackedBox = TemporaryFolderTest;

TEST_F(PackedBox, CarriesItsWeightWithAsManyContactsAsInLammps)
{
  PackingParameters p;
  p.state.file = INTERLOCK_SOURCE_DIR "/cases/benchmark/w1_settled.json.gz";
  p.state.missed_contact_checks = 1;
  p.contact = {1e7, 2. / 3, 0.7, 4000, 2000};
  p.time.step = 1e-5;
  p.warm_up_steps = 1500;
  p.timed_steps = 1000;
  p.records = 5;
  const Summary s = run_case<Packing>(p, folder);
  const auto result = [&](const char* name) { return s.results[name].get<double>(); };
  EXPECT_EQ(s.clumps, 410);
  EXPECT_EQ(s.spheres, 22550);
  EXPECT_NEAR(result("touching_sphere_pairs") / 881, 1, 0.03);
  EXPECT_NEAR(result("carried_weight_over_weight"), 1, 1e-3);
  // Stones that lean against the walls hang on them by friction: the floor alone carries less.
  EXPECT_GT(result("side_wall_friction_N"), 0.01 * result("weight_N"));
  EXPECT_LT(s.energy["relative_error"].get<double>(), 0.01);
}
