// How many ranks a case can use, from what they did with their time.
#include "coupling/loop/rank_times.h"

#include <gtest/gtest.h>

using namespace interlock::coupling;

namespace
{
// A step of a rank in microseconds.
RankTimes rank(double forces, double lattice, double messages, double clumps, double ghosts)
{
  RankTimes t;
  t.steps = 1000;
  t.forces = 1e-3 * forces, t.lattice = 1e-3 * lattice, t.messages = 1e-3 * messages;
  t.clumps = clumps, t.ghosts = ghosts;
  return t;
}
} // namespace

// Work that divides: all of them.
TEST(RankTimes, LargeWorkIsWorthAllRanks)
{
  const BestRanks best = best_number_of_ranks({4, rank(500, 0, 10, 1000, 200)});
  EXPECT_EQ(best.ranks, 4);
  EXPECT_NEAR(1e6 * best.all, 500 / 1.1 + 10, 1);
}

// Fails when messages, or the geogrid that every rank moves, are forgotten.
TEST(RankTimes, SmallWorkIsWorthOne)
{
  EXPECT_EQ(best_number_of_ranks({4, rank(3, 0, 12, 10, 10)}).ranks, 1);
  EXPECT_EQ(best_number_of_ranks({2, rank(4, 60, 3, 10, 10)}).ranks, 1);
  const BestRanks best = best_number_of_ranks({2, rank(40, 20, 5, 400, 0)});
  EXPECT_EQ(best.ranks, 2);
  EXPECT_NEAR(1e6 * best.best, 40 + 20 + 5, 1);
}
