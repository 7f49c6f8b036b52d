// A finished pull-out as it lies on the disk.
#pragma once

#include "coupling/pull_out/pull_out_parameters.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace interlock::apps
{
struct FinishedPull {
  std::filesystem::path folder;
  coupling::PullParameters pull;
  nlohmann::ordered_json summary;
  std::vector<double> place, force;    // of the records that may be used [m], [N]
  std::optional<double> unusable_from; // displacement from which on records were left out [m]
};

// Throws InputError, one sentence, for a folder that is not there, that of a study, of no run, of
// two runs (case_hash.h), of another experiment, or of a run that is not finished.
FinishedPull read_finished_pull(const std::filesystem::path& folder);

// Null where there is no such file, discarded where it is not whole.
nlohmann::ordered_json read_json(const std::filesystem::path& file);
} // namespace interlock::apps
