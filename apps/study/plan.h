// The runs of a study: their names, entries and folders, and which packed state each starts from.
#pragma once

#include "apps/parameter_file.h"
#include "apps/study/design.h"

namespace interlock::apps
{
// One run of the program. Runs that only make a packed state come first in the plan.
struct Task {
  std::string name;                // of its folder and its row: "ribs-rigid_filling-1"
  std::filesystem::path folder;    // below that of the study: "runs/NAME", "states/NAME"
  std::vector<Assignment> entries; // that differ from the base case
  int state = -1;                  // task that makes the state which this one starts from; -1: none
  bool makes_state = false;
  int point = -1, filling = -1; // -1: of a task that makes a state
};

struct Plan {
  StudyFile study;
  std::filesystem::path folder; // absolute
  std::vector<Point> points;
  std::vector<Task> tasks;
  int n_states = 0; // the first tasks

  // What state a task leaves for others.
  std::filesystem::path state_file(const Task& task) const;
};

// Fills everything but the check of entries. Throws InputError, one sentence, when the study shares
// states and the base case is no pull-out.
Plan make_plan(const StudyFile& study, const std::filesystem::path& folder);

// Reads the parameter file of a task as `interlock run` would, with its overrides: all errors, with
// the lines of the study file where they stand.
RunInput read_task(const Plan& plan, const Task& task);

// Of all tasks; the sentences of all that is wrong in any of them, each once. Throws InputError.
std::vector<RunInput> read_tasks(const Plan& plan);
} // namespace interlock::apps
