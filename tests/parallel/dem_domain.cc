// Clumps shared by several ranks against the same clumps on one: not a digit may differ. Every rank
// computes both and compares the clumps that it moves. Runs on one process and, by mpirun, on more.
#include "../dem_crowd.h"
#include "dem/parallel/domain.h"
#include "dem/parallel/partition.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

struct Shared {
  Engine engine;
  Ranks ranks{MPI_COMM_WORLD};
  Domain domain;
  int deals = 0;

  // At first everything is rank 0's.
  Shared(Engine all, const CellGrid& grid) : engine(std::move(all)), domain(ranks, grid)
  {
    for (int i = 0; i < engine.clumps().size(); ++i)
      engine.clumps().ghost[i] = ranks.rank() == 0 ? 0 : 1;
    deal();
  }
  void deal()
  {
    domain.deal(engine);
    ++deals;
  }
  void step(double dt)
  {
    if (domain.has_expired(engine)) deal();
    engine.compute_forces(dt);
    engine.kick_all(dt);
    engine.drift_all(dt, &engine.clumps().ghost);
    domain.refresh(engine);
    engine.move_walls(dt);
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
  ASSERT_EQ(shared.ranks.sum({shared.own()})[0], all.size());
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

CellGrid grid_of_the_crowd()
{
  return {Vector3::Zero(), Vector3::Constant(0.15), 0.055};
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
  Shared shared(crowd::thrown(5, GetParam().pair).engine, grid_of_the_crowd());
  for (int n = 1; n <= 1500; ++n) {
    alone.step(crowd::time_step);
    shared.step(crowd::time_step);
    if (n % 100 == 0) expect_same_digits(shared, alone);
  }
  EXPECT_GT(alone.n_touching_spheres(), 30);
  if (shared.ranks.size() > 1) {
    EXPECT_GT(shared.deals, 3);
  }
  const double friction = alone.energy(crowd::time_step).contact.friction;
  double part = shared.engine.energy(crowd::time_step).contact.friction;
  MPI_Allreduce(MPI_IN_PLACE, &part, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(part, friction, 1e-12 * friction);
}

// Dealt anew at every fifth step, with contacts closed.
TEST_P(SharedCrowd, DealingChangesNoDigit)
{
  Engine alone = crowd::thrown(8, GetParam().pair).engine;
  Shared shared(crowd::thrown(8, GetParam().pair).engine, grid_of_the_crowd());
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
