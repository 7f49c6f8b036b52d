// The stages of a packing run: what each of them remembers. What a stage is: coupling/run/stage.h.
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/run/stage.h"
#include "dem/engine/engine.h"

#include <chrono>

namespace interlock::coupling
{
class Packing;
class RunRecords;

// Wall-clock time of the steps alone. The clock runs from the end of before_step to the begin of
// the next one, so that all is in it that ranks wait for; unless the step has a look in it.
struct StepTimer {
  using Clock = std::chrono::steady_clock;
  double seconds = 0; // so far
  Clock::time_point start{};
  bool runs = false;
};

struct WarmUpStage {
  static constexpr const char* kind = "warm up";
  int done = 0; // steps
  StepTimer timer;
};

struct TimedStage {
  static constexpr const char* kind = "timed";
  int done = 0; // steps, looks included
  bool look_due = false;
  StepTimer timer;
  // Of the steps without a look.
  std::int64_t steps = 0;
  dem::SharedSum<dem::force_grid> floor,
      side_walls; // vertical forces of the stones on walls, downwards [N]
  dem::StepProfile profile;
  EnergyLedger ledger; // of the last look
};

void unite_notes(TimedStage& stage, Packing& packing);
StageStatus before_step(WarmUpStage& stage, Packing& packing, RunRecords& records);
StageStatus before_step(TimedStage& stage, Packing& packing, RunRecords& records);
template <class Stage> void look(Stage&, Packing&, RunRecords&) {}
void look(TimedStage& stage, Packing& packing, RunRecords& records);
void after_step(WarmUpStage& stage, Packing& packing, RunRecords& records);
void after_step(TimedStage& stage, Packing& packing, RunRecords& records);

inline std::string stage_name(const WarmUpStage&)
{
  return WarmUpStage::kind;
}
inline std::string stage_name(const TimedStage&)
{
  return TimedStage::kind;
}

template <class Archive> void exchange(Archive& archive, WarmUpStage& stage)
{
  archive("done", stage.done);
  archive("seconds", stage.timer.seconds, "s");
}
template <class Archive> void exchange(Archive& archive, TimedStage& stage)
{
  archive("done", stage.done);
  archive("seconds", stage.timer.seconds, "s");
  archive("steps", stage.steps);
  archive("floor", stage.floor);
  archive("side_walls", stage.side_walls);
  archive("broad_phase", stage.profile.broad_phase, "s");
  archive("lists", stage.profile.lists, "s");
  archive("contacts", stage.profile.contacts, "s");
  archive("integration", stage.profile.integration, "s");
  archive("ledger", stage.ledger);
}
} // namespace interlock::coupling
