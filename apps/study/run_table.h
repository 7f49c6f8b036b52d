// runs.csv: one row a run of a study.
#pragma once

#include "apps/study/measures.h"
#include "apps/study/plan.h"

#include <optional>

namespace interlock::apps
{
struct RunRow {
  int task = 0;
  std::string status; // done, not usable, failed, not made
  std::string reason; // a full sentence where the status is another one than done
  std::string state_hash, version, commit;
  double not_usable_from = 1e300; // displacement [m]
  std::vector<Measure> measures;
  double wall_time = 0;
};

struct RunTable {
  const Plan* plan = nullptr;
  std::vector<RunRow> rows;          // runs of the plan, in its order
  std::vector<std::string> measures; // names, in the order in which rows first have them

  // What statistics may use: nothing where the run has no result; of one that is not to be used,
  // only what belongs to a displacement before.
  std::optional<double> usable(const RunRow& row, const std::string& measure) const;
};

// Of what is on the disk now.
RunTable read_runs(const Plan& plan);

// Rows in the plan's order, numbers with the digits that give the same double again; nothing in it
// depends on when, where or beside what a run was made.
std::string csv_of(const RunTable& table);
// What does depend on it: time and place of each run.
std::string times_csv(const RunTable& table);

// A cell of a CSV file: in double quotes where it must be (RFC 4180).
std::string csv_cell(const std::string& text);
std::string csv_number(double value); // empty when it is not finite
} // namespace interlock::apps
