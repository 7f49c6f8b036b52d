// The pull of a finished run again, from the state before it, for frames that the first one has
// not.
#pragma once

#include <filesystem>
#include <vector>

namespace interlock::apps
{
struct SecondPull {
  std::filesystem::path first;   // folder of the finished run
  std::filesystem::path folder;  // of this one; what a run has left there is removed
  std::vector<double> frames_at; // displacements, ascending, none beyond the pull [m]
  std::size_t rows = 0; // of history.csv, from the first one on: to where it is pulled and compared
};

// The state that the pull of the run in `folder` began with: the run's own state_before_pull.h5, or
// the one that it was started from. Throws InputError where it is not there any more.
std::filesystem::path state_before_pull(const std::filesystem::path& folder);

// Pulls until the rows of the first run are there again, compares each of them with all its digits
// as soon as it is written, and ends. Throws std::runtime_error at the first one that differs,
// Interrupted when somebody stops it, and what a run throws.
void pull_again(const SecondPull& pull);
} // namespace interlock::apps
