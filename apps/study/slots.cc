#include "apps/study/slots.h"

#include "apps/interruption.h"
#include "apps/ranks.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

namespace interlock::apps
{
namespace
{
enum Tag { tag_start = 1, tag_stop, tag_end, tag_ending };
constexpr std::chrono::milliseconds pause(20);

MPI_Comm world()
{
  return all_ranks().comm();
}

void send(int number, int rank, Tag tag)
{
  MPI_Send(&number, 1, MPI_INT, rank, tag, world());
}

// A message that waits here, if any.
std::optional<std::pair<int, int>> receive(int rank, int tag)
{
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(rank, tag, world(), &there, &status);
  if (there == 0) return {};
  int number = 0;
  MPI_Recv(&number, 1, MPI_INT, rank, status.MPI_TAG, world(), MPI_STATUS_IGNORE);
  return std::make_pair(status.MPI_TAG, number);
}

Slot local_slot(const Plan& plan)
{
  auto child = std::make_shared<ChildRun>();
  Slot slot;
  slot.start = [child, &plan](int task) {
    child->start(TaskFolder(plan, plan.tasks[task]), plan.study.ranks_per_run);
  };
  slot.ending = [child] { return child->ending(); };
  slot.stop = [child] { child->stop(); };
  return slot;
}

Slot remote_slot(int rank)
{
  Slot slot;
  slot.start = [rank](int task) { send(task, rank, tag_start); };
  slot.stop = [rank] { send(0, rank, tag_stop); };
  slot.ending = [rank]() -> std::optional<int> {
    const auto message = receive(rank, tag_ending);
    if (!message) return {};
    return message->second;
  };
  return slot;
}
} // namespace

std::vector<Slot> local_slots(const Plan& plan, int jobs)
{
  std::vector<Slot> slots;
  for (int k = 0; k < jobs; ++k) slots.push_back(local_slot(plan));
  return slots;
}

std::vector<Slot> slots_of_ranks(const Plan& plan)
{
  const int step = plan.study.ranks_per_run, size = all_ranks().size();
  std::vector<Slot> slots = {local_slot(plan)};
  for (int rank = step; rank + step <= size; rank += step) slots.push_back(remote_slot(rank));
  return slots;
}

void serve(const Plan& plan)
{
  Slot mine = local_slot(plan);
  bool stopped = false;
  for (;;) {
    if (const auto message = receive(0, MPI_ANY_TAG)) {
      if (message->first == tag_end) return;
      if (message->first == tag_stop) mine.stop();
      if (message->first == tag_start) mine.start(message->second);
    }
    // A launcher tells all ranks.
    if (is_interrupted() && !stopped) {
      mine.stop();
      stopped = true;
    }
    if (const auto code = mine.ending()) send(*code, 0, tag_ending);
    std::this_thread::sleep_for(pause);
  }
}

void dismiss_servers()
{
  for (int rank = 1; rank < all_ranks().size(); ++rank) send(0, rank, tag_end);
}
} // namespace interlock::apps
