// All entries of all parameter files in one place, from the tables that read them.
#pragma once

#include <string>
#include <vector>

namespace interlock::apps
{
// An entry that means the same in the experiments that have it.
struct ParameterLine {
  std::string key;     // "Section/Name"
  std::string meaning; // a sentence, without the unit
  std::string unit;    // "-" for a pure number; empty where the value is a word
  std::string allowed; // in words: "a number greater than 0"
  std::string usual;   // "1e+05 to 1e+12"; empty where every allowed value is usual
  std::string start;   // the default; "to be given" without one
  std::vector<std::string> experiments; // that have it
};

// In the order of the experiments and of their files. An entry of which meaning, range or default
// differ between experiments has several lines.
std::vector<ParameterLine> parameter_lines();

// Those that have the word in name or meaning; upper and lower case alike.
std::vector<ParameterLine> lines_about(const std::string& word);

// For a terminal: one paragraph a line.
std::string parameter_text(const std::vector<ParameterLine>& lines);

// docs/parameters.md: one table a section.
std::string parameter_page();
} // namespace interlock::apps
