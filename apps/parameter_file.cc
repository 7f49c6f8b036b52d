#include "apps/parameter_file.h"

#include "apps/nearest_name.h"
#include "apps/parameter_scanner.h"
#include "apps/value_error.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <map>
#include <sstream>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using coupling::ParameterEntry;
using coupling::ParameterTable;

// Names that the design gives to experiments to come.
const std::vector<std::string> planned_experiments = {"settle"};

constexpr const char* experiment_entry = "Experiment";

const ParameterEntry* find_entry(const ParameterTable& table, const std::string& key)
{
  const auto& entries = table.entries();
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ParameterEntry& entry) { return entry.key() == key; });
  return found == entries.end() ? nullptr : &*found;
}

// The entry that is probably meant: one of the same name in another section, a similar name in this
// section, or, where there is no such section, a similar section and name. Empty when none is near.
std::string nearest_entry(const ParameterTable& table, const Assignment& assignment)
{
  std::vector<std::string> keys, siblings;
  for (const ParameterEntry& entry : table.entries()) {
    if (entry.name == assignment.name) return entry.key();
    keys.push_back(entry.key());
    if (entry.section == assignment.section) siblings.push_back(entry.name);
  }
  if (siblings.empty()) return nearest_name(assignment.key(), keys);
  Assignment nearest = assignment;
  nearest.name = nearest_name(assignment.name, siblings);
  return nearest.name.empty() ? "" : nearest.key();
}

std::string explain_unknown(const ParameterTable& table, const Assignment& assignment)
{
  const std::string start = "there is no entry \"" + assignment.key() + "\"";
  const std::string nearest = nearest_entry(table, assignment);
  if (!nearest.empty()) return start + "; the nearest known one is \"" + nearest + "\".";
  std::vector<std::string> siblings;
  for (const ParameterEntry& entry : table.entries())
    if (entry.section == assignment.section) siblings.push_back('"' + entry.name + '"');
  if (siblings.empty()) return start + ", nor a section of this name.";
  return start + "; this section has " + boost::algorithm::join(siblings, ", ") + ".";
}

// Later assignments win, those of the command line over those of the file.
class Input
{
public:
  Input(const fs::path& file, const std::vector<std::string>& overrides) : file_(file)
  {
    ScannedFile scanned = scan_parameter_file(file);
    assignments_ = std::move(scanned.assignments);
    errors_ = std::move(scanned.errors);
    for (const std::string& text : overrides) {
      try {
        assignments_.push_back(parse_override(text));
      } catch (const InputError& error) {
        errors_.push_back(error.what());
      }
    }
  }

  // The last one of this entry; null when there is none.
  const Assignment* find(const std::string& key) const
  {
    const Assignment* last = nullptr;
    for (const Assignment& assignment : assignments_)
      if (assignment.key() == key) last = &assignment;
    return last;
  }

  void fill(ParameterTable& table)
  {
    for (const Assignment& assignment : assignments_) {
      places_[assignment.key()] = assignment.place;
      const ParameterEntry* entry = find_entry(table, assignment.key());
      if (!entry)
        errors_.push_back(assignment.place + ": " + explain_unknown(table, assignment));
      else if (!table.set(*entry, resolved(*entry, assignment)))
        add_bad_value(*entry, assignment);
    }
  }

  void find_missing(const ParameterTable& table)
  {
    for (const ParameterEntry& entry : table.entries())
      if (entry.required && places_.count(entry.key()) == 0) add_missing(entry);
  }

  void add_missing(const ParameterEntry& entry)
  {
    errors_.push_back(file_.string() + ": the entry \"" + entry.key() +
                      "\" is missing; it must be " + entry.allowed + in_unit(entry) + " (" +
                      entry.sentence.substr(0, entry.sentence.size() - 1) + ").");
  }

  void add_bad_value(const ParameterEntry& entry, const Assignment& assignment)
  {
    errors_.push_back(assignment.place + ": " + explain_bad_value(entry, assignment.value));
  }

  void add_problem(const coupling::ParameterProblem& problem)
  {
    const auto place = places_.find(problem.entry);
    errors_.push_back((place == places_.end() ? file_.string() : place->second) + ": \"" +
                      problem.entry + "\": " + problem.sentence);
  }

  void throw_errors() const
  {
    if (!errors_.empty()) throw InputError(boost::algorithm::join(errors_, "\n"));
  }

private:
  static std::string in_unit(const ParameterEntry& entry)
  {
    return entry.unit.empty() || entry.unit == "-" ? "" : ", in " + entry.unit;
  }

  static std::string resolved(const ParameterEntry& entry, const Assignment& assignment)
  {
    if (entry.key() == experiment_entry) return present_name(assignment.value);
    if (!entry.is_path || assignment.value.empty()) return assignment.value;
    return fs::absolute(assignment.base / assignment.value).lexically_normal().string();
  }

  fs::path file_;
  std::vector<Assignment> assignments_;
  std::map<std::string, std::string> places_; // of the last assignment of each entry
  std::vector<std::string> errors_;
};

void declare_experiment(ParameterTable& table, std::string& name)
{
  table.require_choice(experiment_entry, name, experiment_names(), "What to simulate.");
}

// The entries that a file may have depend on the experiment: without a good one, no more than that
// and what no line of its kind can be is said.
const Experiment& choose_experiment(Input& input)
{
  const Assignment* assignment = input.find(experiment_entry);
  const Experiment* experiment = assignment ? find_experiment(assignment->value) : nullptr;
  if (experiment) return *experiment;

  const auto& planned = planned_experiments;
  if (assignment && std::count(planned.begin(), planned.end(), assignment->value) > 0)
    throw InputError("\"Experiment\" is \"" + assignment->value +
                     "\", which is not available in this version; it runs \"" +
                     boost::algorithm::join(experiment_names(), "\", \"") + "\".");
  ParameterTable table;
  std::string name;
  declare_experiment(table, name);
  const ParameterEntry& entry = table.entries().front();
  if (assignment)
    input.add_bad_value(entry, *assignment);
  else
    input.add_missing(entry);
  input.throw_errors();
  return *experiment; // never reached
}
} // namespace

RunInput read_parameter_file(const fs::path& file, const std::vector<std::string>& overrides)
{
  Input input(file, overrides);
  RunInput result;
  result.experiment = &choose_experiment(input);
  result.parameters = result.experiment->defaults;

  ParameterTable table;
  std::string name;
  declare_experiment(table, name);
  result.experiment->declare(table, result.parameters);
  input.fill(table);
  input.find_missing(table);
  input.throw_errors();

  for (const auto& problem : result.experiment->check(result.parameters))
    input.add_problem(problem);
  input.throw_errors();

  for (const ParameterEntry& entry : table.entries())
    result.entries.push_back({entry.key(), table.get(entry)});
  std::ostringstream used;
  coupling::write_parameters(used, table);
  result.used = used.str();
  return result;
}
} // namespace interlock::apps
