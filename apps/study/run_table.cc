#include "apps/study/run_table.h"

#include "apps/study/task_folder.h"

#include <boost/algorithm/string.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::apps
{
namespace
{
RunRow read_run(const Plan& plan, int task)
{
  const TaskFolder folder(plan, plan.tasks[task]);
  RunRow row;
  row.task = task;
  const nlohmann::ordered_json summary =
      folder.is_over() ? folder.summary() : nlohmann::ordered_json();
  if (!summary.is_object()) {
    row.reason = folder.last_sentence();
    const int state = plan.tasks[task].state;
    if (row.reason.empty() && state >= 0)
      row.reason = TaskFolder(plan, plan.tasks[state]).last_sentence();
    row.status = row.reason.empty() ? "not made" : "failed";
    return row;
  }
  row.reason = summary.value("not_usable", "");
  row.status = row.reason.empty() ? "done" : "not usable";
  row.state_hash = summary.value("state_hash", "");
  row.version = summary.value("version", "");
  row.commit = summary["origin"].value("commit", "");
  row.wall_time = summary.value("wall_time_s", 0.);
  if (summary["results"].contains("not_usable_from_mm"))
    row.not_usable_from = 1e-3 * summary["results"]["not_usable_from_mm"].get<double>();
  row.measures = measures_of(folder.folder(), summary, plan.study.measures);
  return row;
}
} // namespace

std::optional<double> RunTable::usable(const RunRow& row, const std::string& measure) const
{
  const auto found = std::find_if(row.measures.begin(), row.measures.end(),
                                  [&](const Measure& m) { return m.name == measure; });
  if (found == row.measures.end() || !std::isfinite(found->value)) return {};
  if (found->place >= 0 ? found->place >= row.not_usable_from : row.status != "done") return {};
  return found->value;
}

RunTable read_runs(const Plan& plan)
{
  RunTable table;
  table.plan = &plan;
  for (int task = plan.n_states; task < static_cast<int>(plan.tasks.size()); ++task) {
    table.rows.push_back(read_run(plan, task));
    for (const Measure& measure : table.rows.back().measures)
      if (std::count(table.measures.begin(), table.measures.end(), measure.name) == 0)
        table.measures.push_back(measure.name);
  }
  return table;
}

std::string csv_cell(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  return '"' + boost::replace_all_copy(text, "\"", "\"\"") + '"';
}

std::string csv_number(double value)
{
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string csv_of(const RunTable& table)
{
  const Plan& plan = *table.plan;
  std::vector<std::string> head = {"run", "filling"};
  for (const Factor& factor : plan.study.factors) head.push_back(csv_cell(factor.name));
  head.insert(head.end(), {"status", "reason"});
  for (const std::string& measure : table.measures) head.push_back(csv_cell(measure));
  head.insert(head.end(), {"state_hash", "version", "commit"});
  std::string text = boost::join(head, ",") + '\n';
  for (const RunRow& row : table.rows) {
    const Task& task = plan.tasks[row.task];
    std::vector<std::string> cells = {task.name,
                                      csv_cell(plan.study.fillings.levels[task.filling].name)};
    for (const Level& level : plan.points[task.point].levels) cells.push_back(csv_cell(level.name));
    cells.insert(cells.end(), {row.status, csv_cell(row.reason)});
    for (const std::string& measure : table.measures) {
      const auto found = std::find_if(row.measures.begin(), row.measures.end(),
                                      [&](const Measure& m) { return m.name == measure; });
      cells.push_back(found == row.measures.end() ? "" : csv_number(found->value));
    }
    cells.insert(cells.end(), {row.state_hash, row.version, row.commit});
    text += boost::join(cells, ",") + '\n';
  }
  return text;
}

std::string times_csv(const RunTable& table)
{
  std::string text = "run,wall_time [s],host,date\n";
  for (const Task& task : table.plan->tasks) {
    const auto summary = TaskFolder(*table.plan, task).summary();
    if (!summary.is_object()) continue;
    text += fmt::format(
        "{},{},{},{}\n", task.folder.string(), csv_number(summary.value("wall_time_s", 0.)),
        csv_cell(summary["origin"].value("host", "")), summary["origin"].value("date", ""));
  }
  return text;
}
} // namespace interlock::apps
