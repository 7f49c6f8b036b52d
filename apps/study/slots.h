// Where runs of a study go on: each slot has one at a time, as a child of this process or of
// another rank.
#pragma once

#include "apps/study/child_run.h"

#include <functional>
#include <vector>

namespace interlock::apps
{
struct Slot {
  std::function<void(int task)> start;
  std::function<std::optional<int>()> ending; // exit code of the run, once
  std::function<void()> stop;                 // asks the run to keep its state and end
  int task = -1;                              // that it is busy with; -1: none
};

// `jobs` slots of this process. The plan must outlive them.
std::vector<Slot> local_slots(const Plan& plan, int jobs);

// One slot for each group of `ranks_per_run` ranks of MPI's world; on the first rank, which has the
// first one itself. The others call serve().
std::vector<Slot> slots_of_ranks(const Plan& plan);

// On the other ranks: does what the first one asks for, until it says that the study is over.
void serve(const Plan& plan);
// On the first rank, at the end.
void dismiss_servers();
} // namespace interlock::apps
