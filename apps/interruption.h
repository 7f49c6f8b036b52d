// Control-C and a batch system's `terminate`: the run stops at the next step instead of in the
// middle of a file.
#pragma once

#include <exception>
#include <functional>
#include <string>

namespace interlock::apps
{
class Interrupted : public std::exception
{
public:
  explicit Interrupted(std::string sentence = "interrupted") : sentence_(std::move(sentence)) {}
  const char* what() const noexcept override { return sentence_.c_str(); }

private:
  std::string sentence_;
};

// From now on SIGINT and SIGTERM only leave a mark; a second one ends the program at once.
void catch_interruption();

// While it lives, is_interrupted() also asks `asked`, on the thread that wants to know: for a host
// with signals of its own, such as Python. One at a time.
class InterruptionSource
{
public:
  explicit InterruptionSource(std::function<bool()> asked);
  ~InterruptionSource();
  InterruptionSource(const InterruptionSource&) = delete;
  InterruptionSource& operator=(const InterruptionSource&) = delete;
};

// Whether the mark is there; throws Interrupted once it is.
bool is_interrupted();
void throw_if_interrupted();
} // namespace interlock::apps
