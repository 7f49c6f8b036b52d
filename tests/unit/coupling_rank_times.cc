// How many ranks a case can use, from what they did with their time.
#include "coupling/loop/rank_times.h"

#include <gtest/gtest.h>

using namespace interlock::coupling;

namespace
{
// A step of a rank in microseconds.
RankTimes rank(double forces, double geogrid, double copying, double clumps, double ghosts)
{
  RankTimes t;
  t.steps = 1000;
  t.forces = 1e-3 * forces, t.geogrid = 1e-3 * geogrid, t.copying = 1e-3 * copying;
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

// Fails when copying or the geogrid is forgotten.
TEST(RankTimes, SmallWorkIsWorthOne)
{
  EXPECT_EQ(best_number_of_ranks({4, rank(3, 0, 12, 10, 10)}).ranks, 1);
  // One rank with the geogrid, which is all there is to do.
  EXPECT_EQ(best_number_of_ranks({rank(2, 60, 3, 10, 10), rank(4, 0, 50, 20, 10)}).ranks, 1);
  EXPECT_EQ(best_number_of_ranks({rank(9, 30, 4, 100, 100), rank(60, 0, 5, 400, 100)}).ranks, 2);
}
