#include "coupling/loop/rank_times.h"

#include <algorithm>

namespace interlock::coupling
{
BestRanks best_number_of_ranks(const std::vector<RankTimes>& times)
{
  const int n = static_cast<int>(times.size());
  double stones = 0, geogrid = 0, kept = 0, copying = 0; // of a step
  for (const RankTimes& t : times) {
    const double steps = std::max<double>(1, static_cast<double>(t.steps));
    // A pair of a stone and a ghost is evaluated twice.
    const double own = t.clumps + 0.5 * t.ghosts > 0 ? t.clumps / (t.clumps + 0.5 * t.ghosts) : 1;
    stones += own * t.forces / steps;
    geogrid = std::max(geogrid, t.geogrid / steps);
    copying = copying == 0 ? t.copying / steps : std::min(copying, t.copying / steps);
    copying += &t == &times.back() ? t.sharing / steps : 0;
    if (t.geogrid > 0.5 * t.forces) kept = own * t.forces / steps;
  }
  const auto step = [&](int ranks) {
    if (ranks == 1) return stones + geogrid;
    const double busiest =
        geogrid > 0 ? std::max(geogrid + kept, (stones + geogrid) / ranks) : stones / ranks;
    return busiest + copying;
  };
  BestRanks result;
  result.best = step(1);
  for (int ranks = 2; ranks <= n; ++ranks) {
    // A few percent are not worth a core.
    if (step(ranks) < 0.95 * result.best) result = {ranks, step(ranks), 0};
  }
  result.all = step(n);
  return result;
}
} // namespace interlock::coupling
