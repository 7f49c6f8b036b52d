#include "apps/parameter_page.h"

#include "apps/experiments.h"
#include "coupling/parameters/usual_ranges.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace interlock::apps
{
namespace
{
std::string usual_text(const std::string& key)
{
  const coupling::UsualRange* range = coupling::usual_range(key);
  return range ? fmt::format("{:g} to {:g}", range->lower, range->upper) : "";
}

bool same_entry(const ParameterLine& a, const ParameterLine& b)
{
  return a.key == b.key && a.meaning == b.meaning && a.allowed == b.allowed && a.start == b.start;
}

void add_lines(const Experiment& experiment, std::vector<ParameterLine>& lines)
{
  coupling::ParameterTable table;
  ExperimentParameters parameters = experiment.defaults;
  experiment.declare(table, parameters);
  if (experiment.declare_product) experiment.declare_product(table, parameters);
  for (const coupling::ParameterEntry& entry : table.entries()) {
    const std::string value = table.get(entry);
    ParameterLine line{entry.key(),
                       entry.sentence,
                       entry.unit,
                       entry.allowed,
                       usual_text(entry.key()),
                       entry.required  ? "to be given"
                       : value.empty() ? "empty"
                                       : value,
                       {experiment.name}};
    const auto known = std::find_if(lines.begin(), lines.end(), [&](const ParameterLine& other) {
      return same_entry(other, line);
    });
    if (known == lines.end())
      lines.push_back(std::move(line));
    else
      known->experiments.push_back(experiment.name);
  }
}

std::string section_of(const ParameterLine& line)
{
  const std::size_t slash = line.key.find('/');
  return slash == std::string::npos ? "" : line.key.substr(0, slash);
}

// A bar would end a cell of a table.
std::string cell(const std::string& text)
{
  return boost::algorithm::replace_all_copy(text, "|", "\\|");
}

std::string row(const ParameterLine& line)
{
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", cell(line.key), cell(line.meaning),
                     line.unit, cell(line.allowed), line.usual, cell(line.start),
                     line.experiments.size() == experiments().size()
                         ? "all"
                         : boost::algorithm::join(line.experiments, ", "));
}
} // namespace

std::vector<ParameterLine> parameter_lines()
{
  std::vector<ParameterLine> lines;
  for (const Experiment& experiment : experiments()) add_lines(experiment, lines);
  return lines;
}

std::vector<ParameterLine> lines_about(const std::string& word)
{
  std::vector<ParameterLine> found;
  const std::vector<ParameterLine> lines = parameter_lines();
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(found),
               [&](const ParameterLine& line) {
                 return boost::algorithm::icontains(line.key, word) ||
                        boost::algorithm::icontains(line.meaning, word);
               });
  return found;
}

std::string parameter_text(const std::vector<ParameterLine>& lines)
{
  std::string text;
  for (const ParameterLine& line : lines) {
    text += fmt::format("{}{}\n  {}\n  {}; default: {}", line.key,
                        line.unit.empty() || line.unit == "-" ? "" : " [" + line.unit + "]",
                        line.meaning, line.allowed, line.start);
    if (!line.usual.empty()) text += "; usual: " + line.usual;
    text += "\n  in: " + boost::algorithm::join(line.experiments, ", ") + "\n";
  }
  return text;
}

std::string parameter_page()
{
  std::vector<ParameterLine> lines = parameter_lines();
  std::vector<std::string> sections;
  for (const ParameterLine& line : lines)
    if (std::find(sections.begin(), sections.end(), section_of(line)) == sections.end())
      sections.push_back(section_of(line));
  std::string page =
      "# Every parameter\n\n"
      "Made by `interlock parameters --page`; `interlock parameters friction` shows those about a "
      "word. A parameter file has the entries of its experiment; `interlock template NAME` prints "
      "one to start from. A value outside what is usual is most often a slip of the unit and is "
      "refused unless `--unusual` insists. Entries of study files: [studies.md](studies.md).\n";
  for (const std::string& section : sections) {
    page += fmt::format("\n## {}\n\n", section.empty() ? "At the top" : section);
    page += "| Entry | Meaning | Unit | Allowed | Usual | Default | Experiments |\n"
            "|---|---|---|---|---|---|---|\n";
    for (const ParameterLine& line : lines)
      if (section_of(line) == section) page += row(line);
  }
  return page;
}
} // namespace interlock::apps
