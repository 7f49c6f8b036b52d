#include "apps/study/plan.h"

#include "coupling/pull_out/start_from.h"
#include "coupling/run/checkpoints.h"
#include "dem/input_error.h"

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using Assignments = std::vector<Assignment>;

// Longer names of folders are numbers instead.
constexpr std::size_t longest_name = 120;

// The shortest pull: only the state before it is wanted.
const std::vector<std::string> no_pull = {
    "Pull/Speed=0.01",  "Pull/Distance=2e-5",    "Pull/Ramp time=1e-3", "Geogrid/Break strain=0",
    "Output/Records=1", "Output/Field frames=0", "Output/Report=false"};

// For file names: letters, digits and . + - remain.
std::string plain(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+' ? c : '-';
  return result;
}

// The name of a factor in file names: an entry without its section, unless two would be the same.
std::string short_name(const StudyFile& study, const Factor& factor)
{
  const auto last = [](const std::string& name) { return name.substr(name.rfind('/') + 1); };
  const auto same = std::count_if(study.factors.begin(), study.factors.end(), [&](const Factor& f) {
    return last(f.name) == last(factor.name);
  });
  return plain(same > 1 ? factor.name : last(factor.name));
}

void append(Assignments& entries, const Assignments& more)
{
  entries.insert(entries.end(), more.begin(), more.end());
}

class Planner
{
public:
  Planner(const StudyFile& study, const fs::path& folder)
  {
    plan_.study = study;
    plan_.folder = fs::absolute(folder).lexically_normal();
    plan_.points = design_points(study);
    for (std::size_t p = 0; p < plan_.points.size(); ++p) {
      if (plan_.points[p].filling >= 0) {
        add_run(static_cast<int>(p), plan_.points[p].filling);
        continue;
      }
      for (std::size_t f = 0; f < study.fillings.levels.size(); ++f)
        add_run(static_cast<int>(p), static_cast<int>(f));
    }
    plan_.n_states = static_cast<int>(states_.size());
    for (Task& run : runs_) states_.push_back(std::move(run));
    plan_.tasks = std::move(states_);
  }

  Plan take() { return std::move(plan_); }

private:
  void add_run(int p, int f)
  {
    const StudyFile& study = plan_.study;
    Task task;
    task.point = p, task.filling = f;
    task.name = run_name(p, f);
    task.folder = fs::path("runs") / task.name;
    task.entries = study.fixed;
    append(task.entries, study.fillings.levels[f].entries);
    for (const Level& level : plan_.points[p].levels) append(task.entries, level.entries);
    if (study.start_from != "nothing") start_from_state(task);
    runs_.push_back(std::move(task));
  }

  void start_from_state(Task& task)
  {
    task.state = state_for(task);
    Assignment entry = parse_override(
        "Start from=" + (plan_.folder / plan_.state_file(states_[task.state])).string());
    entry.place = plan_.study.file.string();
    task.entries.push_back(entry);
  }

  // One state for all runs that agree in what it fixes, the filling among that.
  int state_for(const Task& run)
  {
    Task state;
    state.makes_state = true;
    state.entries = plan_.study.fixed;
    append(state.entries, plan_.study.fillings.levels[run.filling].entries);
    std::string name;
    for (const Level& level : plan_.points[run.point].levels)
      for (const Assignment& entry : level.entries)
        if (acts_before_state(entry.key())) {
          state.entries.push_back(entry);
          name += plain(entry.name) + '-' + plain(entry.value) + '_';
        }
    for (const std::string& text : no_pull) {
      state.entries.push_back(parse_override(text));
      state.entries.back().place = plan_.study.file.string();
    }
    const auto [found, first] =
        states_by_case_.emplace(case_of(state), static_cast<int>(states_.size()));
    if (!first) return found->second;
    name += filling_name(run.filling);
    const bool taken =
        std::any_of(states_.begin(), states_.end(), [&](const Task& s) { return s.name == name; });
    if (taken || name.size() > longest_name) name = "state-" + std::to_string(states_.size() + 1);
    state.name = name;
    state.folder = fs::path("states") / name;
    states_.push_back(std::move(state));
    return found->second;
  }

  // All values; of a case that is refused, which read_tasks() will say, the changes.
  std::string case_of(const Task& task) const
  {
    try {
      return read_varied_file(plan_.study.base_case, task.entries).used;
    } catch (const InputError&) {
      std::string changes;
      for (const Assignment& entry : task.entries)
        changes += entry.key() + '=' + entry.value + '\n';
      return changes;
    }
  }

  bool acts_before_state(const std::string& key) const
  {
    return coupling::is_fixed_by_state(key, plan_.study.start_from == "packed") ||
           (!plan_.study.refilled.empty() && coupling::is_among(key, plan_.study.refilled));
  }

  std::string filling_name(int f) const
  {
    return "filling-" + plain(plan_.study.fillings.levels[f].name);
  }

  // By what it is, so that a level or a filling more leaves the other names; by its number where
  // points were drawn.
  std::string run_name(int p, int f) const
  {
    const Point& point = plan_.points[p];
    const bool drawn = std::count(point.places.begin(), point.places.end(), -1) > 0;
    std::string name;
    for (std::size_t k = 0; k < point.levels.size() && !drawn; ++k)
      name +=
          short_name(plan_.study, plan_.study.factors[k]) + '-' + plain(point.levels[k].name) + '_';
    if (drawn || name.size() > longest_name) {
      std::ostringstream number;
      number << "point-" << p + 1 << '_';
      name = number.str();
    }
    return name + filling_name(f);
  }

  Plan plan_;
  std::vector<Task> states_, runs_;
  std::map<std::string, int> states_by_case_; // places in states_
};

void check_experiment(const Plan& plan)
{
  if (plan.study.start_from == "nothing") return;
  const RunInput base = read_varied_file(plan.study.base_case, plan.study.fixed);
  if (base.experiment->name != "pull-out")
    throw InputError(plan.study.file.string() + ": \"Start from\" is \"" + plan.study.start_from +
                     "\", but the base case is the experiment \"" + base.experiment->name +
                     "\", and only a pull-out leaves states to start from.");
}

void check_names(const Plan& plan)
{
  std::map<std::string, int> names;
  for (const Task& task : plan.tasks)
    if (!task.makes_state && ++names[task.name] > 1)
      throw InputError(
          plan.study.file.string() + ": two runs have the name \"" + task.name +
          "\", which is made of letters, digits, . and + of the levels alone; name the "
          "levels otherwise.");
}
} // namespace

fs::path Plan::state_file(const Task& task) const
{
  return task.folder /
         (study.start_from == "packed" ? "state_before_pull.h5" : "state_before_geogrid.h5");
}

Plan make_plan(const StudyFile& study, const fs::path& folder)
{
  Plan plan = Planner(study, folder).take();
  check_experiment(plan);
  check_names(plan);
  return plan;
}

RunInput read_task(const Plan& plan, const Task& task)
{
  Assignments entries;
  // Figures of hundreds of runs are asked for, or not made.
  const bool asked = std::any_of(plan.study.fixed.begin(), plan.study.fixed.end(),
                                 [](const Assignment& a) { return a.key() == "Output/Report"; });
  const RunInput base = read_varied_file(plan.study.base_case, {});
  const bool draws = std::any_of(base.entries.begin(), base.entries.end(),
                                 [](const auto& e) { return e.key == "Output/Report"; });
  if (draws && !asked) entries.push_back(parse_override("Output/Report=false"));
  append(entries, task.entries);
  return read_varied_file(plan.study.base_case, entries);
}

std::vector<RunInput> read_tasks(const Plan& plan)
{
  std::vector<RunInput> inputs;
  std::vector<std::string> sentences; // each once, in the order in which they come
  for (const Task& task : plan.tasks) {
    try {
      inputs.push_back(read_task(plan, task));
    } catch (const InputError& error) {
      std::vector<std::string> lines;
      boost::split(lines, std::string(error.what()), boost::is_any_of("\n"));
      for (const std::string& line : lines)
        if (std::count(sentences.begin(), sentences.end(), line) == 0) sentences.push_back(line);
    }
  }
  if (!sentences.empty()) throw InputError(boost::join(sentences, "\n"));
  return inputs;
}
} // namespace interlock::apps
