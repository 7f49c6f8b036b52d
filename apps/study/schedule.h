// Which run of a study comes next, and what became of each.
#pragma once

#include "apps/study/slots.h"

namespace interlock::apps
{
// What happens, for the terminal.
struct ScheduleEvents {
  std::function<void(int task)> started;
  std::function<void(int task, bool well, const std::string& sentence)> ended;
  std::function<void()> waits; // many times a second
};

// Makes all runs of `tasks` (indices of the plan, states before what starts from them) that are not
// over yet, as many at a time as there are slots. A run that fails does not end the others, but
// those that start from its state are not made. On an interrupt the runs are asked to keep their
// states; throws Interrupted when they have.
void run_tasks(const Plan& plan, const std::vector<int>& tasks, std::vector<Slot>& slots,
               const ScheduleEvents& events);
} // namespace interlock::apps
