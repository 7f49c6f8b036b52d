// The stages of a heap run: what each of them remembers. What a stage is: coupling/run/stage.h.
#pragma once

#include "coupling/run/stage.h"

namespace interlock::coupling
{
class Heap;
class RunRecords;

// Lets the stones go, each at its time or as soon after it as its place is free.
struct DropStage {
  static constexpr const char* kind = "drop";
  int released = 0; // stones so far
};

// Until the last stone has landed and then until the kinetic energy is low.
struct HeapSettleStage {
  static constexpr const char* kind = "settle";
  bool begun = false, still = false, recorded = false;
  double begin = 0;   // [s]
  double kinetic = 0; // at the last look [J]
};

StageStatus before_step(DropStage& stage, Heap& heap, RunRecords& records);
StageStatus before_step(HeapSettleStage& stage, Heap& heap, RunRecords& records);
void look(DropStage& stage, Heap& heap, RunRecords& records);
void look(HeapSettleStage& stage, Heap& heap, RunRecords& records);
void unite_notes(DropStage& stage, Heap& heap);
void unite_notes(HeapSettleStage& stage, Heap& heap);
void after_step(DropStage& stage, Heap& heap, RunRecords& records);
void after_step(HeapSettleStage& stage, Heap& heap, RunRecords& records);

inline std::string stage_name(const DropStage&)
{
  return DropStage::kind;
}
inline std::string stage_name(const HeapSettleStage&)
{
  return HeapSettleStage::kind;
}

template <class Archive> void exchange(Archive& archive, DropStage& stage)
{
  archive("released", stage.released);
}
template <class Archive> void exchange(Archive& archive, HeapSettleStage& stage)
{
  archive("begun", stage.begun);
  archive("still", stage.still);
  archive("recorded", stage.recorded);
  archive("begin", stage.begin, "s");
  archive("kinetic", stage.kinetic, "J");
}
} // namespace interlock::coupling
