// Clumps shared by several ranks against the same clumps on one: not a digit may differ. Every rank
// computes both and compares the clumps that it moves. Runs on one process and, by mpirun, on more.
#include "../dem_crowd.h"
#include "dem/parallel/agreement.h"
#include "dem/parallel/domain.h"
#include "dem/parallel/partition.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

struct Shared {
  Engine engine;
  Ranks ranks{MPI_COMM_WORLD};
  Agreement agreement{ranks};
  Domain domain{ranks};
  int deals = 0;

  explicit Shared(Engine all) : engine(std::move(all)) { deal(); }
  void deal()
  {
    domain.deal(engine);
    ++deals;
  }
  void step(double dt)
  {
    if (agreement.exchange(domain.has_expired(engine, dt) ? 1 : 0) != 0) deal();
    engine.compute_forces(dt);
    engine.kick_all(dt);
    engine.drift_all(dt, &engine.clumps().ghost);
    domain.start_refresh(engine);
    engine.move_walls(dt);
    domain.finish_refresh(engine);
  }
  int own() const
  {
    int count = 0;
    for (int i = 0; i < engine.clumps().size(); ++i) count += engine.clumps().ghost[i] == 0;
    return count;
  }
};

void expect_same_digits(const Shared& shared, const Engine& alone)
{
  const Clumps &ours = shared.engine.clumps(), &all = alone.clumps();
  const int owners = shared.domain.is_whole() ? shared.ranks.size() : 1;
  ASSERT_EQ(shared.ranks.sum({shared.own()})[0], owners * all.size());
  for (int i = 0; i < ours.size(); ++i) {
    const int k = all.index_of(ours.id[i]);
    ASSERT_GE(k, 0);
    ASSERT_EQ(ours.position[i], all.position[k]) << "clump " << ours.id[i];
    ASSERT_EQ(ours.orientation[i].coeffs(), all.orientation[k].coeffs()) << "clump " << ours.id[i];
    if (ours.ghost[i] == 1) continue;
    ASSERT_EQ(ours.velocity[i], all.velocity[k]) << "clump " << ours.id[i];
    ASSERT_EQ(ours.angular_momentum[i], all.angular_momentum[k]) << "clump " << ours.id[i];
  }
}

} // namespace

class SharedCrowd : public testing::TestWithParam<crowd::Law>
{
};
INSTANTIATE_TEST_SUITE_P(Laws, SharedCrowd, testing::ValuesIn(crowd::laws()),
                         [](const auto& law) { return law.param.name; });

// Thrown clumps cross from rank to rank. Fails when a contact is missed or counted twice, when a
// history is lost on the way, or when forces are summed in another order.
TEST_P(SharedCrowd, HasTheDigitsOfOneRank)
{
  Engine alone = crowd::thrown(5, GetParam().pair).engine;
  Shared shared(crowd::thrown(5, GetParam().pair).engine);
  for (int n = 1; n <= 1500; ++n) {
    alone.step(crowd::time_step);
    shared.step(crowd::time_step);
    if (n % 100 == 0) expect_same_digits(shared, alone);
  }
  EXPECT_GT(alone.n_touching_spheres(), 30);
  if (shared.ranks.size() > 1) {
    EXPECT_GT(shared.deals, 3);
  }
}

// Everything back on every rank: what clumps have lost, forces on walls, and a look at the energies
// after another step. Fails when something stays behind, or is summed in another order.
TEST_P(SharedCrowd, GatheredIsWhatOneRankHas)
{
  Engine alone = crowd::thrown(6, GetParam().pair).engine;
  Shared shared(crowd::thrown(6, GetParam().pair).engine);
  for (int n = 0; n < 3; ++n) {
    for (int m = 0; m < 301; ++m) {
      alone.step(crowd::time_step);
      shared.step(crowd::time_step);
    }
    EXPECT_EQ(shared.ranks.largest(shared.own()) < 60, shared.ranks.size() > 1);
    shared.domain.gather(shared.engine);
    ASSERT_EQ(shared.own(), alone.clumps().size());
    expect_same_digits(shared, alone);
    for (int i = 0; i < alone.clumps().size(); ++i) {
      ASSERT_EQ(shared.engine.clumps().lost[i], alone.clumps().lost[i]);
      ASSERT_EQ(shared.engine.clumps().lost_to_crushing[i], alone.clumps().lost_to_crushing[i]);
    }
    ASSERT_EQ(shared.engine.walls()[0].force, alone.walls()[0].force);
    alone.compute_forces(crowd::time_step);
    shared.engine.compute_forces(crowd::time_step);
    const EngineEnergy ours = shared.engine.energy(crowd::time_step),
                       all = alone.energy(crowd::time_step);
    EXPECT_EQ(ours.kinetic, all.kinetic);
    EXPECT_EQ(ours.contact.elastic, all.contact.elastic);
    EXPECT_EQ(ours.contact.friction, all.contact.friction);
    EXPECT_EQ(ours.contact.damping, all.contact.damping);
    EXPECT_EQ(ours.contact.crushing, all.contact.crushing);
    EXPECT_EQ(all.contact.crushing > 0, GetParam().pair.crushing_pressure > 0);
    for (Engine* engine : {&alone, &shared.engine}) {
      engine->kick_all(crowd::time_step);
      engine->drift_all(crowd::time_step);
    }
    shared.deal();
  }
  EXPECT_GT(Vector3(alone.walls()[0].force).norm(), 0);
}

// Dealt anew at every fifth step, with contacts closed.
TEST_P(SharedCrowd, DealingChangesNoDigit)
{
  Engine alone = crowd::thrown(8, GetParam().pair).engine;
  Shared shared(crowd::thrown(8, GetParam().pair).engine);
  for (int n = 1; n <= 800; ++n) {
    alone.step(crowd::time_step);
    if (n % 5 == 0) shared.deal();
    shared.step(crowd::time_step);
  }
  expect_same_digits(shared, alone);
}

// Fails when a rank gets nothing or nearly all of an even load.
TEST(Partition, SharesAnEvenLoad)
{
  const CellGrid grid(Vector3::Zero(), Vector3(1, 1, 0.5), 0.1);
  for (const int ranks : {1, 2, 3, 4, 7}) {
    const std::vector<int> owner = partition(grid, std::vector<int>(grid.size(), 3), ranks);
    std::vector<int> cells(ranks, 0);
    for (const int rank : owner) ++cells.at(rank);
    for (const int count : cells) {
      EXPECT_GT(count, 0.8 * grid.size() / ranks);
      EXPECT_LT(count, 1.2 * grid.size() / ranks);
    }
  }
}

// Where half of the load lies in a corner, that corner is divided.
TEST(Partition, GoesByTheLoad)
{
  const CellGrid grid(Vector3::Zero(), Vector3(1, 1, 0.5), 0.1);
  std::vector<int> cost(grid.size(), 1);
  const int dear = grid.size() / 8;
  for (int cell = 0; cell < dear; ++cell) cost[cell] = 8;
  const std::vector<int> owner = partition(grid, cost, 2);
  double of_first = 0, all = 0;
  for (int cell = 0; cell < grid.size(); ++cell) {
    all += cost[cell];
    if (owner[cell] == 0) of_first += cost[cell];
  }
  EXPECT_NEAR(of_first / all, 0.5, 0.05);
}

// Fails when a neighbour is missing, listed twice, or not mutual.
TEST(CellGrid, NearPlacesLieInNeighbours)
{
  const CellGrid grid(Vector3(-1, 0, 2), Vector3(1, 1, 3), 0.3);
  RandomStream random(3);
  for (int n = 0; n < 2000; ++n) {
    const Vector3 x(random.uniform(-1.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(1, 4));
    const int a = grid.cell_of(x), b = grid.cell_of(x + 0.3 * random.direction());
    if (a == b) continue;
    const std::vector<int> of_a = grid.neighbours(a), of_b = grid.neighbours(b);
    EXPECT_EQ(std::count(of_a.begin(), of_a.end(), b), 1);
    EXPECT_EQ(std::count(of_b.begin(), of_b.end(), a), 1);
  }
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  MPI_Finalize();
  return failed;
}
