#include "coupling/parameters/parameter_table.h"

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace interlock::coupling
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

std::string allowed_numbers(const Range& range, const std::string& kind)
{
  std::ostringstream words;
  words << kind;
  if (std::isfinite(range.upper)) {
    if (range.lower_included)
      words << " from " << range.lower << " to " << range.upper;
    else
      words << " greater than " << range.lower << " and at most " << range.upper;
  } else if (range.lower_included) {
    words << " of " << range.lower << " or more";
  } else {
    words << " greater than " << range.lower;
  }
  return words.str();
}

// The patterns of deal.II include their bounds, so an excluded one moves by one unit in the last
// place.
dealii::Patterns::Double pattern_of(const Range& range)
{
  return {range.lower_included ? range.lower : std::nextafter(range.lower, infinity),
          std::min(range.upper, largest)};
}

dealii::Patterns::Integer integer_pattern_of(const Range& range)
{
  constexpr double most = std::numeric_limits<int>::max();
  return {static_cast<int>(range.lower), static_cast<int>(std::min(range.upper, most))};
}

// Any value that the pattern takes: deal.II refuses to declare an entry without one.
double some_value(const Range& range)
{
  return std::min(std::max(1., range.lower), range.upper);
}

std::string quoted_choices(const std::vector<std::string>& choices)
{
  std::string words;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) words += i + 1 == choices.size() ? " or " : ", ";
    words += '"' + choices[i] + '"';
  }
  return words;
}

dealii::Patterns::Selection pattern_of(const std::vector<std::string>& choices)
{
  return dealii::Patterns::Selection(boost::algorithm::join(choices, "|"));
}
// A value that a reader would take for something else gets quotes: # starts a comment, a backslash
// at the end continues the line, blanks at the ends are cut off.
std::string as_written(const std::string& value)
{
  const bool plain = value.find('#') == std::string::npos && !boost::ends_with(value, "\\") &&
                     !boost::starts_with(value, "\"") && boost::trim_copy(value) == value;
  return plain ? value : '"' + value + '"';
}
} // namespace

const Range positive{0, infinity, false};
const Range not_negative{0, infinity, true};

std::string ParameterEntry::key() const
{
  return section.empty() ? name : section + "/" + name;
}

ParameterTable::ParameterTable() : handler_(std::make_unique<dealii::ParameterHandler>()) {}
ParameterTable::~ParameterTable() = default;
ParameterTable::ParameterTable(ParameterTable&&) noexcept = default;

void ParameterTable::open_section(const std::string& name)
{
  section_ = name;
}

template <typename T>
void ParameterTable::bind(const std::string& name, T& member, const T& start,
                          const dealii::Patterns::PatternBase& pattern, const std::string& allowed,
                          const std::string& text, const bool required)
{
  ParameterEntry entry;
  entry.section = section_, entry.name = name, entry.sentence = text;
  entry.allowed = allowed, entry.required = required;
  const auto bracket = text.rfind(" [");
  if (bracket != std::string::npos && text.back() == ']') {
    entry.sentence = text.substr(0, bracket);
    entry.unit = text.substr(bracket + 2, text.size() - bracket - 3);
  }
  entries_.push_back(entry);

  // A required member keeps what it holds until it is set: the start value only satisfies the
  // pattern.
  const T before = member;
  member = start;
  if (!section_.empty()) handler_->enter_subsection(section_);
  handler_->add_parameter(name, member, text, pattern, required);
  if (!section_.empty()) handler_->leave_subsection();
  if (required) member = before;
}

void ParameterTable::require(const std::string& name, double& member, const Range& range,
                             const std::string& text)
{
  bind(name, member, some_value(range), pattern_of(range), allowed_numbers(range, "a number"), text,
       true);
}

void ParameterTable::require(const std::string& name, int& member, const Range& range,
                             const std::string& text)
{
  bind(name, member, static_cast<int>(some_value(range)), integer_pattern_of(range),
       allowed_numbers(range, "a whole number"), text, true);
}

void ParameterTable::require(const std::string& name, bool& member, const std::string& text)
{
  bind(name, member, false, dealii::Patterns::Bool(), "\"true\" or \"false\"", text, true);
}

void ParameterTable::require_unless(const std::string& other, const std::string& name,
                                    double& member, const Range& range, const std::string& text)
{
  offer(name, member, 0, range, text);
  entries_.back().required = true;
  entries_.back().replaced_by = other;
}

void ParameterTable::require_choice(const std::string& name, std::string& member,
                                    const std::vector<std::string>& choices,
                                    const std::string& text)
{
  bind(name, member, choices.front(), pattern_of(choices), quoted_choices(choices), text, true);
}

void ParameterTable::offer(const std::string& name, double& member, const double start,
                           const Range& range, const std::string& text)
{
  bind(name, member, start, pattern_of(range), allowed_numbers(range, "a number"), text, false);
}

void ParameterTable::offer(const std::string& name, int& member, const int start,
                           const Range& range, const std::string& text)
{
  bind(name, member, start, integer_pattern_of(range), allowed_numbers(range, "a whole number"),
       text, false);
}

void ParameterTable::offer(const std::string& name, bool& member, const bool start,
                           const std::string& text)
{
  bind(name, member, start, dealii::Patterns::Bool(), "\"true\" or \"false\"", text, false);
}

void ParameterTable::offer_list(const std::string& name, std::vector<double>& member,
                                const std::string& text)
{
  const dealii::Patterns::List pattern(pattern_of(not_negative), 0,
                                       dealii::Patterns::List::max_int_value);
  bind(name, member, {}, pattern, "numbers of 0 or more, with commas between them, or nothing",
       text, false);
}

void ParameterTable::offer_seed(const std::string& name, std::uint64_t& member,
                                const std::string& text)
{
  const Range range{0, std::numeric_limits<int>::max(), true};
  bind(name, member, member, integer_pattern_of(range), "a whole number from 0 to 2147483647", text,
       false);
}

void ParameterTable::offer_choice(const std::string& name, std::string& member,
                                  const std::string& start, const std::vector<std::string>& choices,
                                  const std::string& text)
{
  bind(name, member, start, pattern_of(choices), quoted_choices(choices), text, false);
}

void ParameterTable::offer_text(const std::string& name, std::string& member,
                                const std::string& text)
{
  bind(name, member, std::string(), dealii::Patterns::Anything(), "any text", text, false);
  entries_.back().is_text = true;
}

void ParameterTable::require_file(const std::string& name, std::string& member,
                                  const std::string& text)
{
  bind(name, member, std::string(), dealii::Patterns::FileName(), "the name of a file", text, true);
  entries_.back().is_path = true;
}

void ParameterTable::offer_file(const std::string& name, std::string& member,
                                const std::string& text)
{
  bind(name, member, std::string(), dealii::Patterns::FileName(), "the name of a file", text,
       false);
  entries_.back().is_path = true;
}

void ParameterTable::offer_input_file(const std::string& name, std::string& member,
                                      const std::string& text)
{
  offer_file(name, member, text);
  entries_.back().is_input = true;
}

void ParameterTable::offer_folder(const std::string& name, std::string& member,
                                  const std::string& text)
{
  bind(name, member, std::string(), dealii::Patterns::DirectoryName(), "the name of a folder", text,
       false);
  entries_.back().is_path = true;
}

bool ParameterTable::set(const ParameterEntry& entry, const std::string& value)
{
  bool allowed = true;
  if (!entry.section.empty()) handler_->enter_subsection(entry.section);
  try {
    handler_->set(entry.name, value);
  } catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern&) {
    allowed = false;
  }
  if (!entry.section.empty()) handler_->leave_subsection();
  return allowed;
}

std::string ParameterTable::get(const ParameterEntry& entry) const
{
  if (!entry.section.empty()) handler_->enter_subsection(entry.section);
  const std::string value = handler_->get(entry.name);
  if (!entry.section.empty()) handler_->leave_subsection();
  return value;
}

void write_parameters(std::ostream& out, const ParameterTable& table)
{
  std::string section;
  for (const ParameterEntry& entry : table.entries()) {
    if (entry.section != section) {
      if (!section.empty()) out << "end\n";
      section = entry.section;
      out << "\nsubsection " << section << '\n';
    }
    const std::string indent = section.empty() ? "" : "  ";
    out << indent << "# " << entry.sentence;
    if (!entry.unit.empty()) out << " [" << entry.unit << ']';
    out << '\n' << indent << "set " << entry.name << " = " << as_written(table.get(entry)) << '\n';
  }
  if (!section.empty()) out << "end\n";
}
} // namespace interlock::coupling
