// One simulation of a case into its folder, as the command line and Python start it: the folder and
// its lock, run.log, used.prm, the stages, summary.json, figures.
#pragma once

#include "apps/parameter_file.h"

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace interlock::apps
{
struct CaseRun {
  std::filesystem::path folder; // of the output
  bool resume = false;          // go on from the checkpoint there; from the beginning without one
  bool force = false;           // remove the results of an earlier run first
  std::string resume_line;      // what to type to go on, for the sentence of a run that was stopped
  // What the run says while it works, beside run.log; null: nothing. It outlives the run.
  std::ostream* screen = nullptr;
  bool screen_is_terminal = false;

  // Both may be empty. `ready` gets the experiment before its first step: whoever keeps a copy
  // keeps alive the world that `watch` is shown, every hundred steps, between two of them. What
  // `watch` throws ends the run at once; interruption.h asks it to keep its state.
  std::function<void(const ReadyExperiment&)> ready;
  std::function<void(const coupling::Progress&)> watch;
};

// All ranks call it, after start_mpi(). Throws InputError before anything is written, Interrupted
// once an interruption (interruption.h) was obeyed and the state kept, and whatever the simulation
// throws; std::runtime_error, with everything written, when the result is not to be used.
coupling::Summary run_case(const RunInput& input, const CaseRun& run);
} // namespace interlock::apps
