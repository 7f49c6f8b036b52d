#include "apps/study/study_conclusion.h"

#include "apps/figure_script.h"
#include "apps/study/study_results.h"
#include "coupling/files/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::apps
{
void write_results(const RunTable& table)
{
  const Plan& plan = *table.plan;
  const auto write = [&](const char* name, const std::string& text) {
    coupling::write_atomically(plan.folder / name, text);
  };
  write("means.csv", means_csv(table));
  write("differences.csv", differences_csv(table));
  write("variance.csv", variance_csv(table));
  write("times.csv", times_csv(table));
  const std::string curves = curves_h5(table);
  if (!curves.empty()) write("curves.h5", curves);
  write("runs.csv", csv_of(table));
}

void conclude(const Plan& plan, const std::function<void(const std::string&)>& say)
{
  const RunTable table = read_runs(plan);
  write_results(table);
  const auto count = [&](const char* status) {
    return std::count_if(table.rows.begin(), table.rows.end(),
                         [&](const RunRow& row) { return row.status == status; });
  };
  const auto done = count("done"), all = static_cast<std::ptrdiff_t>(table.rows.size());
  if (done + count("not usable") > 0) {
    const ScriptResult figures = run_figure_script("study_figures.py", {plan.folder.string()});
    if (figures.status != 0) say("warning: the figures could not be drawn: " + figures.reason);
    const ScriptResult page = run_figure_script("report.py", {plan.folder.string()});
    if (page.status != 0) say("warning: report.html could not be written: " + page.reason);
  }
  for (const RunRow& row : table.rows)
    if (row.status != "done")
      say(fmt::format("{}: {}{}", plan.tasks[row.task].name, row.status,
                      row.reason.empty() ? "." : ": " + row.reason));
  say(fmt::format("{} of {} runs are done. Everything is in {}.", done, all, plan.folder.string()));
  if (done < all)
    throw std::runtime_error(
        fmt::format("{} of {} runs of the study are missing or not to be used; runs.csv "
                    "says why",
                    all - done, all));
}
} // namespace interlock::apps
