#include "coupling/loop/rank_times.h"

#include <algorithm>

namespace interlock::coupling
{
BestRanks best_number_of_ranks(const std::vector<RankTimes>& times)
{
  const int n = static_cast<int>(times.size());
  double stones = 0, lattice = 0, messages = 0; // of a step
  for (const RankTimes& t : times) {
    const double steps = std::max<double>(1, static_cast<double>(t.steps));
    // A pair of a stone and a ghost is evaluated twice.
    const double own = t.clumps + 0.5 * t.ghosts > 0 ? t.clumps / (t.clumps + 0.5 * t.ghosts) : 1;
    stones += (own * t.forces + t.ribs) / steps;
    lattice = std::max(lattice, t.lattice / steps);
    messages = messages == 0 ? t.messages / steps : std::min(messages, t.messages / steps);
    messages += &t == &times.back() ? t.sharing / steps : 0;
  }
  const auto step = [&](int ranks) {
    return stones / ranks + lattice + (ranks == 1 ? 0 : messages);
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
