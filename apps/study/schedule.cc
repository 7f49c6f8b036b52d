#include "apps/study/schedule.h"

#include "apps/interruption.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

namespace interlock::apps
{
namespace
{
constexpr std::chrono::milliseconds pause(20);
constexpr int refused = 2; // exit code

class Schedule
{
public:
  Schedule(const Plan& plan, const std::vector<int>& tasks, std::vector<Slot>& slots,
           const ScheduleEvents& events)
      : plan_(plan), waiting_(tasks), slots_(slots), events_(events)
  {
  }

  void run()
  {
    bool told = false;
    for (;;) {
      if (is_interrupted() && !told) {
        for (Slot& slot : slots_)
          if (slot.task >= 0) slot.stop();
        told = true;
      }
      if (!told)
        for (Slot& slot : slots_)
          if (slot.task < 0) start_next(slot);
      const bool busy = std::any_of(slots_.begin(), slots_.end(),
                                    [](const Slot& slot) { return slot.task >= 0; });
      if (!busy && (told || waiting_.empty())) break;
      for (Slot& slot : slots_) end(slot);
      events_.waits();
      std::this_thread::sleep_for(pause);
    }
    if (told) throw Interrupted("interrupted; the same command goes on with the study");
  }

private:
  TaskFolder folder(int task) const { return {plan_, plan_.tasks[task]}; }

  // Of a state that others are to start from: whether it can be.
  bool is_made(int state) const
  {
    std::error_code error;
    return folder(state).is_over() &&
           std::filesystem::exists(plan_.folder / plan_.state_file(plan_.tasks[state]), error);
  }

  bool is_under_way(int task) const
  {
    return std::count(waiting_.begin(), waiting_.end(), task) > 0 ||
           std::any_of(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.task == task; });
  }

  void start_next(Slot& slot)
  {
    for (std::size_t k = 0; k < waiting_.size();) {
      const int task = waiting_[k], state = plan_.tasks[task].state;
      if (state >= 0 && !is_made(state) && is_under_way(state)) {
        ++k;
        continue;
      }
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(k));
      if (folder(task).is_over()) continue;
      if (state >= 0 && !is_made(state)) {
        events_.ended(task, false,
                      "not made: the state \"" + plan_.tasks[state].name + "\" is missing");
        continue;
      }
      slot.task = task;
      events_.started(task);
      slot.start(task);
      return;
    }
  }

  void end(Slot& slot)
  {
    if (slot.task < 0) return;
    const std::optional<int> code = slot.ending();
    if (!code) return;
    const int task = slot.task;
    slot.task = -1;
    if (is_interrupted()) return;
    // A checkpoint that cannot be gone on with: once more from the beginning.
    if (*code == refused && folder(task).progress() == TaskProgress::stopped &&
        started_anew_.insert(task).second) {
      folder(task).forget();
      waiting_.insert(waiting_.begin(), task);
      return;
    }
    const bool well = folder(task).is_over() && (*code == 0 || plan_.tasks[task].makes_state);
    const std::string said = folder(task).last_sentence();
    events_.ended(task, well,
                  said.empty() && !well ? "it ended with code " + std::to_string(*code) + "."
                                        : said);
  }

  const Plan& plan_;
  std::vector<int> waiting_;
  std::vector<Slot>& slots_;
  const ScheduleEvents& events_;
  std::set<int> started_anew_;
};
} // namespace

void run_tasks(const Plan& plan, const std::vector<int>& tasks, std::vector<Slot>& slots,
               const ScheduleEvents& events)
{
  Schedule(plan, tasks, slots, events).run();
}
} // namespace interlock::apps
