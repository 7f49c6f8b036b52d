// From a parameter file and the command line to parameters that can be run.
#pragma once

#include "apps/experiments.h"
#include "apps/parameter_scanner.h"

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
struct RunInput {
  const Experiment* experiment = nullptr;             // of the table of experiments
  ExperimentParameters parameters;                    // those of this experiment
  std::vector<coupling::CaseEntry> entries;           // all values as text, paths absolute
  std::vector<coupling::ParameterEntry> descriptions; // of these entries
  // The same as states keep them: of an input file its name and a hash of its content.
  std::vector<coupling::CaseEntry> kept;
  std::string used; // a complete parameter file of all values, defaults included, paths absolute
};

// Reads `file` (parameter_scanner.h), then `overrides` ("Section/Entry=value"), and checks
// everything. Throws InputError that names all errors at once, one full sentence a line: unknown
// entries with the nearest known name, values outside their range or with a unit typed into them,
// missing entries, parameters that contradict each other, an experiment that this version cannot
// run.
RunInput read_parameter_file(const std::filesystem::path& file,
                             const std::vector<std::string>& overrides = {});
// The same with overrides that stand in another file, whose lines the sentences name.
RunInput read_varied_file(const std::filesystem::path& file,
                          const std::vector<Assignment>& overrides);
} // namespace interlock::apps
