// What a study will take, before it begins.
#pragma once

#include "apps/study/task_folder.h"

#include <functional>

namespace interlock::apps
{
struct TaskCost {
  double time = 0; // processor time on one core [s]
  double disk = 0; // [bytes]
};

struct Outlook {
  std::vector<TaskCost> tasks; // of the plan
  double measured_share = 0; // time of runs that are over, over what was forecast for them; 0: none
};

// Asks the forecast of the experiment, which makes the same checks as `interlock check`, once for
// each point (its first filling), or of more than 32 points for as many, evenly spaced, the next
// ones counting alike; a run that is over counts with the time that it took, and the others are
// then scaled by how far the forecast was off. Throws InputError when a combination cannot be run.
// `checked` is called before each forecast.
Outlook look_ahead(const Plan& plan, const std::vector<RunInput>& inputs,
                   const std::function<void(int done, int all)>& checked);

// Wall-clock time [s] of the tasks that are not over, on so many slots at a time.
double time_left(const Plan& plan, const Outlook& outlook, int slots);

// How many runs, how long, how much disk: two or three sentences.
std::string announcement(const Plan& plan, const Outlook& outlook, int slots);
} // namespace interlock::apps
