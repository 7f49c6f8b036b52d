#include "apps/study/outlook.h"

#include "apps/interruption.h"
#include "apps/progress.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace interlock::apps
{
namespace
{
// A forecast makes the stones of a run, which takes a second.
constexpr std::size_t most_forecasts = 32;
constexpr double least_disk = 1e5; // of a run: history, summary, log [bytes]

// Without the state to start from, which is not made yet: the same checks for all other entries.
coupling::Forecast forecast_of(const Plan& plan, const Task& task)
{
  Task alone = task;
  alone.entries.push_back(parse_override("Start from="));
  if (plan.study.start_from == "nothing") alone.entries.pop_back();
  const RunInput input = read_task(plan, alone);
  coupling::RunRequest request;
  request.entries = input.kept;
  request.monitor.progress = [](const coupling::Progress&) { throw_if_interrupted(); };
  try {
    return input.experiment->forecast(input.parameters, request);
  } catch (const InputError& error) {
    throw InputError("The run \"" + task.name + "\" of the study: " + error.what());
  }
}

// Of the stages that the task itself makes.
TaskCost cost_of(const Plan& plan, const Task& task, const coupling::Forecast& forecast)
{
  TaskCost cost;
  cost.disk = least_disk + forecast.disk();
  const std::string first = plan.study.start_from == "packed" ? "settle" : "place geogrid";
  bool shared = task.state >= 0;
  for (const coupling::StageForecast& stage : forecast.stages) {
    if (stage.name == first) shared = false;
    if (!shared && !(task.makes_state && stage.name == "pull")) cost.time += forecast.time(stage);
  }
  return cost;
}

// Runs of one point cost the same, whatever their filling.
std::map<std::pair<bool, int>, std::vector<int>> alike(const Plan& plan)
{
  std::map<std::pair<bool, int>, std::vector<int>> groups;
  for (int k = 0; k < static_cast<int>(plan.tasks.size()); ++k) {
    const Task& task = plan.tasks[k];
    groups[{task.makes_state, task.makes_state ? 0 : task.point}].push_back(k);
  }
  return groups;
}
} // namespace

Outlook look_ahead(const Plan& plan, const std::vector<RunInput>& inputs,
                   const std::function<void(int done, int all)>& checked)
{
  Outlook outlook;
  outlook.tasks.resize(inputs.size());
  const auto groups = alike(plan);
  const std::size_t step = 1 + (groups.size() - 1) / most_forecasts;
  double measured = 0, expected = 0;
  TaskCost last;
  std::size_t number = 0;
  for (const auto& group : groups) {
    throw_if_interrupted();
    const Task& first = plan.tasks[group.second.front()];
    if (number % step == 0 || first.makes_state) {
      checked(static_cast<int>(number), static_cast<int>(groups.size()));
      last = cost_of(plan, first, forecast_of(plan, first));
    }
    if (!first.makes_state) ++number;
    for (const int k : group.second) {
      outlook.tasks[k] = last;
      const nlohmann::ordered_json summary = TaskFolder(plan, plan.tasks[k]).summary();
      if (!summary.is_object()) continue;
      measured += summary.value("wall_time_s", 0.) * summary.value("ranks", 1);
      expected += last.time;
    }
  }
  if (measured > 0 && expected > 0) outlook.measured_share = measured / expected;
  if (outlook.measured_share > 0)
    for (TaskCost& cost : outlook.tasks) cost.time *= outlook.measured_share;
  return outlook;
}

double time_left(const Plan& plan, const Outlook& outlook, int slots)
{
  // As the schedule does it: the next run goes to the slot that is free first.
  const auto pass = [&](bool states) {
    std::vector<double> busy(slots, 0.);
    for (std::size_t k = 0; k < plan.tasks.size(); ++k) {
      if (plan.tasks[k].makes_state != states || TaskFolder(plan, plan.tasks[k]).is_over())
        continue;
      *std::min_element(busy.begin(), busy.end()) +=
          outlook.tasks[k].time / plan.study.ranks_per_run;
    }
    return *std::max_element(busy.begin(), busy.end());
  };
  return pass(true) + pass(false);
}
std::string announcement(const Plan& plan, const Outlook& outlook, int slots)
{
  const int runs = static_cast<int>(plan.tasks.size()) - plan.n_states;
  int over = 0;
  double time = 0, disk = 0;
  for (std::size_t k = 0; k < plan.tasks.size(); ++k) {
    disk += outlook.tasks[k].disk;
    if (TaskFolder(plan, plan.tasks[k]).is_over())
      ++over;
    else
      time += outlook.tasks[k].time;
  }
  std::string text = fmt::format("{} runs: {} points, {} fillings", runs, plan.points.size(),
                                 plan.study.fillings.levels.size());
  if (plan.n_states > 0)
    text += fmt::format("; they start from {} states, made first", plan.n_states);
  text +=
      over > 0 ? fmt::format(". {} of {} are there already.\n", over, plan.tasks.size()) : ".\n";
  text += fmt::format("About {} of processor time are left, {} at {} a time; files about {}. ",
                      duration_text(time), duration_text(time_left(plan, outlook, slots)), slots,
                      bytes_text(disk));
  return text + (outlook.measured_share > 0 ? "Times follow the runs that are there."
                                            : "Times are estimates, good to a factor of two.");
}
} // namespace interlock::apps
