// The time step of a run: given, or a share of the stable one.
#pragma once

#include "coupling/parameters/parameter_table.h"
#include "coupling/parameters/step_rule.h"

#include <string>

namespace interlock::coupling
{
struct TimeParameters {
  double step = 0;          // 0: safety factor times the stable step [s]
  double safety_factor = 0; // share of the stable step [-]
};

// The step bound is meant for clumps with this many contacts, more than stones in a packing carry
// on average; a live bound is watched during the run.
constexpr int expected_contacts = 8;

// Opens the section Time and declares both members of `time`, which must outlive the table.
void declare_time(ParameterTable& table, TimeParameters& time);

// What the step is made of, in one sentence for the log: the shape that sets it, counted from 1,
// its contacts, the bound and the share of it that is used.
std::string time_step_budget(double step, const dem::StableStep& stable);

// Of a run whose step follows its contacts; that of a given step stays as it is.
StepRule step_rule(const TimeParameters& time, const dem::StableStep& stable);

// [s]. Throws InputError, one full sentence that names the shape (from 1) which sets the stable
// step, when the given step is above it.
double choose_time_step(const TimeParameters& time, const dem::StableStep& stable);
} // namespace interlock::coupling
