// What a stage of a run is: plain data with three functions.
//
//   StageStatus before_step(Stage&, Experiment&, RunRecords&);  // the protocol
//   void look(Stage&, Experiment&, RunRecords&);                // measures, forces and poses
//   agree;
//                                                               // only where before_step wants it
//   void after_step(Stage&, Experiment&, RunRecords&);          // what the step did
//
// Everything that a stage waits for or adds up is a member of its data and in its field list
// `exchange(archive, stage)`, so that a run can stop between any two steps and go on in another
// process. `stage_name(stage)` is its name in the log.
#pragma once

#include <string>

namespace interlock::coupling
{
// Whether look() wants to see the step to come, and with everything on every rank or with the part
// that each rank has: the functions of World that ask all ranks are enough then.
enum class Look { none, at_part, at_everything };

struct StageStatus {
  bool finished = false; // no step is made any more, the next stage begins
  double fraction = 0;   // of the stage that is done, 0 to 1; negative where nobody can tell
  Look look = Look::none;
  std::string result; // of a finished stage, a sentence without a full stop for the log
};

inline StageStatus running(double fraction, Look look = Look::none)
{
  return {false, fraction, look, {}};
}
inline StageStatus finished(std::string result)
{
  return {true, 1, Look::none, std::move(result)};
}

// Makes what ranks have noted each for its own stones the same on all, before a state is kept. A
// stage that notes such things has an overload.
template <class Stage, class Experiment> void unite_notes(Stage&, Experiment&) {}

// File for the state before a stage that other runs may start at; empty: none. A stage of that kind
// has an overload.
template <class Stage> std::string start_state(const Stage&)
{
  return {};
}
} // namespace interlock::coupling
