// How a run tells the outside what it is doing. The library itself never prints.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace interlock::coupling
{
class World;

struct Progress {
  std::string stage;          // "pull"
  double fraction = 0;        // of the stage that is done, 0 to 1; negative where nobody can tell
  double simulated_time = 0;  // since the start of the run [s]
  std::int64_t steps = 0;     // since the start of the run
  int number = 0, stages = 0; // the stage is the `number`-th, from 1, of so many; 0: not known
  double later_stages = 0;    // expected time of those to come over that of this one; 0: not known
  // What moves, between two steps and during the call only; null where nothing does: while a run is
  // prepared, and in experiments without steps.
  const World* world = nullptr;
};

// All may be empty. They are called from one thread: `progress` every hundred steps or so (the
// receiver throttles), `message` once for each finished sentence (a stage that ended, a warning),
// `stop_requested` after every step: when it says yes, the run keeps its state and ends.
struct Monitor {
  std::function<void(const Progress&)> progress;
  std::function<void(const std::string&)> message;
  std::function<bool()> stop_requested;
};
} // namespace interlock::coupling
