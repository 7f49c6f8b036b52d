// How a run ends other than well.
#pragma once

#include <stdexcept>
#include <string>

namespace interlock::coupling
{
// The simulation cannot go on: one full sentence with time, place and what to change.
class RunFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Somebody asked to stop in the middle of something that cannot be kept halfway.
struct StopRequested {
};

// Somebody asked the run to stop. Its state is in the file `checkpoint()`; empty: there is none
// yet.
class RunStopped : public std::exception
{
public:
  explicit RunStopped(std::string checkpoint) : checkpoint_(std::move(checkpoint)) {}
  const char* what() const noexcept override { return "stopped on request"; }
  const std::string& checkpoint() const { return checkpoint_; }

private:
  std::string checkpoint_;
};
} // namespace interlock::coupling
