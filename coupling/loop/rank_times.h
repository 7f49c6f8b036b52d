// What ranks do with their time, and how many of them a case can use.
#pragma once

#include <cstdint>
#include <vector>

namespace interlock::coupling
{
// Of one rank, of the steps in which it had its part of the stones only, and of the dealing and
// gathering between them. Wall-clock [s].
struct RankTimes {
  std::int64_t steps = 0;
  double forces = 0;   // of the contacts between stones, and at walls
  double ribs = 0;     // of the contacts with ribs, and moving stones at them
  double lattice = 0;  // of the geogrid, which each rank near it moves itself
  double messages = 0; // copies of ghosts, loads on ribs; waiting for other ranks included
  double sharing = 0;  // dealing and gathering
  std::int64_t deals = 0, gathers = 0;
  double clumps = 0, ghosts = 0; // mean numbers here [-]
};

// The number of ranks, up to that of `times`, with which a step is expected to be fastest, and the
// times that are expected for a step with that number and with all [s]. The work of the stones is
// divided, every rank moves the geogrid, and messages cost what they cost the rank that waits
// least.
struct BestRanks {
  int ranks = 1;
  double best = 0, all = 0; // [s]
};
BestRanks best_number_of_ranks(const std::vector<RankTimes>& times);
} // namespace interlock::coupling
