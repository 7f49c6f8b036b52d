// One run of a study as a child process: `interlock run`, alone or on several ranks.
#pragma once

#include "apps/study/task_folder.h"

#include <optional>

#include <sys/types.h>

namespace interlock::apps
{
class ChildRun
{
public:
  ChildRun() = default;
  ChildRun(const ChildRun&) = delete;
  ChildRun& operator=(const ChildRun&) = delete;
  ~ChildRun(); // ends a child that still runs, and waits for it

  bool runs() const { return child_ > 0; }

  // Goes on with the run where it was, or starts it. Nothing reaches the terminal: what the run
  // says is in its log, and errors in messages(). The child has a process group of its own, so that
  // the terminal's Control-C reaches it through stop() alone, and gets SIGTERM when this process
  // dies.
  void start(const TaskFolder& task, int ranks);
  // SIGTERM: the run keeps its state and ends.
  void stop();
  // The exit code, once; minus the signal that ended it. 127: it could not be started.
  std::optional<int> ending();

private:
  pid_t child_ = 0;
  std::filesystem::path messages_;
};
} // namespace interlock::apps
