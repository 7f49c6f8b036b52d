// Control-C and a batch system's `terminate`: the run stops at the next step instead of in the
// middle of a file.
#pragma once

#include <exception>

namespace interlock::apps
{
class Interrupted : public std::exception
{
public:
  const char* what() const noexcept override { return "interrupted"; }
};

// From now on SIGINT and SIGTERM only leave a mark; a second one ends the program at once.
void catch_interruption();

// Throws Interrupted once the mark is there.
void throw_if_interrupted();
} // namespace interlock::apps
