#include "apps/parameter_file.h"

#include "apps/nearest_name.h"
#include "apps/parameter_scanner.h"
#include "apps/value_error.h"
#include "coupling/check_parameters.h"
#include "coupling/parameter_table.h"
#include "coupling/pull_out_declarations.h"
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

const std::vector<std::string> experiments = {"pull-out", "heap", "settle", "packing", "geogrid"};

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

  const std::string* value_of(const std::string& key) const
  {
    const std::string* value = nullptr;
    for (const Assignment& assignment : assignments_)
      if (assignment.key() == key) value = &assignment.value;
    return value;
  }

  void fill(ParameterTable& table)
  {
    for (const Assignment& assignment : assignments_) {
      places_[assignment.key()] = assignment.place;
      const ParameterEntry* entry = find_entry(table, assignment.key());
      if (!entry)
        errors_.push_back(assignment.place + ": " + explain_unknown(table, assignment));
      else if (!table.set(*entry, resolved(*entry, assignment)))
        errors_.push_back(assignment.place + ": " + explain_bad_value(*entry, assignment.value));
    }
  }

  void find_missing(const ParameterTable& table)
  {
    for (const ParameterEntry& entry : table.entries())
      if (entry.required && places_.count(entry.key()) == 0)
        errors_.push_back(file_.string() + ": the entry \"" + entry.key() +
                          "\" is missing; it must be " + entry.allowed + in_unit(entry) + " (" +
                          entry.sentence.substr(0, entry.sentence.size() - 1) + ").");
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
    if (!entry.is_path || assignment.value.empty()) return assignment.value;
    return fs::absolute(assignment.base / assignment.value).lexically_normal().string();
  }

  fs::path file_;
  std::vector<Assignment> assignments_;
  std::map<std::string, std::string> places_; // of the last assignment of each entry
  std::vector<std::string> errors_;
};

// The entries that a file may have depend on the experiment, so another one gets this sentence
// alone.
void check_experiment(const Input& input)
{
  const std::string* experiment = input.value_of("Experiment");
  if (experiment && *experiment != experiments.front() &&
      std::count(experiments.begin(), experiments.end(), *experiment) == 1)
    throw InputError("\"Experiment\" is \"" + *experiment +
                     "\", which is not available in this version; it runs \"" +
                     experiments.front() + "\".");
}
} // namespace

RunInput read_parameter_file(const fs::path& file, const std::vector<std::string>& overrides)
{
  Input input(file, overrides);
  check_experiment(input);

  RunInput result;
  ParameterTable table;
  std::string experiment;
  table.require_choice("Experiment", experiment, {experiments.front()}, "What to simulate.");
  coupling::declare_pull_out(table, result.parameters);
  input.fill(table);
  input.find_missing(table);
  input.throw_errors();

  for (const auto& problem : coupling::check_parameters(result.parameters))
    input.add_problem(problem);
  input.throw_errors();

  std::ostringstream used;
  coupling::write_parameters(used, table);
  result.used = used.str();
  return result;
}
} // namespace interlock::apps
