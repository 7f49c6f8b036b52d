// Wall-clock time of a piece of code.
#pragma once

#include <chrono>

namespace interlock::coupling
{
// Adds the time from its making to its end to a sum [s], if there is one.
class Stopwatch
{
public:
  explicit Stopwatch(double& sum) : Stopwatch(&sum) {}
  explicit Stopwatch(double* sum) : sum_(sum)
  {
    if (sum_) start_ = Clock::now();
  }
  ~Stopwatch()
  {
    if (sum_) *sum_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double* sum_;
  Clock::time_point start_;
};
} // namespace interlock::coupling
