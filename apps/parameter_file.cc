#include "apps/parameter_file.h"

#include "apps/case_hash.h"
#include "apps/product_section.h"
#include "apps/unknown_entry.h"
#include "apps/value_error.h"
#include "coupling/parameters/usual_ranges.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <fmt/format.h>

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
constexpr const char* unusual_entry = "Unusual values";

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

  Input(const fs::path& file, const std::vector<Assignment>& overrides)
      : Input(file, std::vector<std::string>())
  {
    assignments_.insert(assignments_.end(), overrides.begin(), overrides.end());
  }

  // The last one of this entry; null when there is none.
  const Assignment* find(const std::string& key) const
  {
    const Assignment* last = nullptr;
    for (const Assignment& assignment : assignments_)
      if (assignment.key() == key) last = &assignment;
    return last;
  }

  // Entries of the file that `product_entry` names come first, so that the case may change some of
  // them. Whether the case has a product: that of a file, or a section of its own.
  bool take_product(const std::string& product_entry)
  {
    if (product_entry.empty()) return false;
    product_entry_ = product_entry;
    const Assignment* naming = find(product_entry);
    const bool has_file = naming && !naming->value.empty();
    const std::size_t errors_before = errors_.size();
    if (has_file) {
      const Assignment line = *naming;
      const auto product = product_section(product_file(line), line, errors_);
      assignments_.insert(assignments_.begin(), product.begin(), product.end());
      if (errors_.size() > errors_before) throw_errors(); // nobody knows what is missing
    }
    has_product_ =
        has_file || std::any_of(assignments_.begin(), assignments_.end(),
                                [](const Assignment& a) { return a.section == "Product"; });
    return has_product_;
  }

  void fill(ParameterTable& table)
  {
    for (const Assignment& assignment : assignments_) {
      places_[assignment.key()] = assignment.place;
      const ParameterEntry* entry = find_entry(table, assignment.key());
      if (!entry)
        errors_.push_back(assignment.place + ": " + explain_unknown(table, assignment));
      else if (cut_by_comment(*entry, assignment))
        errors_.push_back(fmt::format(
            "{}: \"{}\" is followed by \"{}\", and # starts a comment; where it belongs to the "
            "value, write it in double quotes: \"{} {}\".",
            assignment.place, assignment.value, assignment.comment, assignment.value,
            assignment.comment));
      else if (!table.set(*entry, resolved(*entry, assignment)))
        add_bad_value(*entry, assignment);
    }
  }

  // What is most likely a slip, such as another unit.
  void find_unusual(const ParameterTable& table)
  {
    for (const ParameterEntry& entry : table.entries()) {
      if (!coupling::usual_range(entry.key())) continue;
      std::vector<std::string> values; // several of a list
      const std::string all = table.get(entry);
      boost::algorithm::split(values, all, boost::algorithm::is_any_of(","));
      for (const std::string& value : values) {
        const std::string why =
            coupling::why_unusual(entry.key(), std::strtod(value.c_str(), nullptr), entry.unit);
        if (!why.empty())
          add_problem({entry.key(),
                       fmt::format("It is {} {}, {}. {}", boost::algorithm::trim_copy(value),
                                   entry.unit, why, how_to_insist),
                       true});
      }
    }
  }

  void find_missing(const ParameterTable& table)
  {
    for (const ParameterEntry& entry : table.entries())
      if (entry.required && places_.count(entry.key()) == 0 && !is_replaced(entry))
        add_missing(entry);
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

  static constexpr const char* how_to_insist = "With --unusual it is taken as it is.";

  void throw_errors() const
  {
    if (!errors_.empty()) throw InputError(boost::algorithm::join(errors_, "\n"));
  }

private:
  // A name or a path that most likely goes on behind the #: no blank between it and the next word,
  // or a file of the whole name.
  static bool cut_by_comment(const ParameterEntry& entry, const Assignment& assignment)
  {
    if (assignment.comment.empty() || !(entry.is_path || entry.is_text)) return false;
    if (assignment.comment.size() > 1 && assignment.comment[1] != ' ' &&
        assignment.comment[1] != '\t' && assignment.comment[1] != '#')
      return true;
    std::error_code error;
    return entry.is_path &&
           fs::exists(assignment.base / (assignment.value + " " + assignment.comment), error);
  }

  static std::string in_unit(const ParameterEntry& entry)
  {
    return entry.unit.empty() || entry.unit == "-" ? "" : ", in " + entry.unit;
  }

  bool is_replaced(const ParameterEntry& entry) const
  {
    return has_product_ && entry.replaced_by == product_entry_;
  }

  std::string resolved(const ParameterEntry& entry, const Assignment& assignment) const
  {
    if (entry.key() == product_entry_ && !assignment.value.empty())
      return product_file(assignment).string();
    if (entry.key() == experiment_entry) return present_name(assignment.value);
    if (!entry.is_path || assignment.value.empty()) return assignment.value;
    return fs::absolute(assignment.base / assignment.value).lexically_normal().string();
  }

  fs::path file_;
  std::vector<Assignment> assignments_;
  std::map<std::string, std::string> places_; // of the last assignment of each entry
  std::vector<std::string> errors_;
  std::string product_entry_; // take_product()
  bool has_product_ = false;
};

// Entries of every experiment.
struct CommonParameters {
  std::string experiment;
  bool unusual = false;
};

void declare_common(ParameterTable& table, CommonParameters& common)
{
  table.require_choice(experiment_entry, common.experiment, experiment_names(),
                       "What to simulate.");
  table.offer(unusual_entry, common.unusual, false,
              "Take values that are far from those of ballast and geogrids as they are.");
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
  CommonParameters common;
  declare_common(table, common);
  const ParameterEntry& entry = table.entries().front();
  if (assignment)
    input.add_bad_value(entry, *assignment);
  else
    input.add_missing(entry);
  input.throw_errors();
  return *experiment; // never reached
}

// Of an input file its name and content count, not where it lies.
std::string value_in_state(const ParameterTable& table, const ParameterEntry& entry)
{
  const std::string value = table.get(entry);
  if (!entry.is_input || value.empty()) return value;
  return fmt::format("{} ({})", fs::path(value).filename().string(), file_hash(value));
}

RunInput checked(Input input)
{
  RunInput result;
  result.experiment = &choose_experiment(input);
  result.parameters = result.experiment->defaults;

  ParameterTable table;
  CommonParameters common;
  declare_common(table, common);
  result.experiment->declare(table, result.parameters);
  if (input.take_product(result.experiment->product_entry))
    result.experiment->declare_product(table, result.parameters);
  input.fill(table);
  input.find_missing(table);
  input.throw_errors();

  for (const auto& problem : result.experiment->check(result.parameters))
    if (!problem.unusual)
      input.add_problem(problem);
    else if (!common.unusual)
      input.add_problem({problem.entry, problem.sentence + " " + Input::how_to_insist, true});
  if (!common.unusual) input.find_unusual(table);
  input.throw_errors();

  // The section Product has it all now, wherever its file goes.
  if (!result.experiment->product_entry.empty())
    table.set(*find_entry(table, result.experiment->product_entry), "");
  for (const ParameterEntry& entry : table.entries()) {
    result.entries.push_back({entry.key(), table.get(entry)});
    result.kept.push_back({entry.key(), value_in_state(table, entry)});
  }
  result.descriptions = table.entries();
  std::ostringstream used;
  coupling::write_parameters(used, table);
  result.used = used.str();
  return result;
}
} // namespace

RunInput read_parameter_file(const fs::path& file, const std::vector<std::string>& overrides)
{
  return checked(Input(file, overrides));
}

RunInput read_varied_file(const fs::path& file, const std::vector<Assignment>& overrides)
{
  return checked(Input(file, overrides));
}
} // namespace interlock::apps
