// What a finished run of a study is held to: numbers by name, from summary.json and history.csv.
#pragma once

#include "apps/study/study_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace interlock::apps
{
struct Measure {
  std::string name;  // carries its unit: "peak_force_N"
  double value = 0;  // not a number: the run does not say
  double place = -1; // displacement that it belongs to [m]; negative: the whole run
};

// history.csv: columns by name without unit; text columns are left out. Empty where there is no
// such file.
std::map<std::string, std::vector<double>> read_history(const std::filesystem::path& run);

// Of a pull-out first those read off its history (docs/studies.md defines them), then all numbers
// of the results in the summary, in their order.
std::vector<Measure> measures_of(const std::filesystem::path& run,
                                 const nlohmann::ordered_json& summary,
                                 const MeasureOptions& options);
} // namespace interlock::apps
