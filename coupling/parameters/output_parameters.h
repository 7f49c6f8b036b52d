// What a test of stones writes, and where it ends too early. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/parameter_table.h"

namespace interlock::coupling
{
// Where a run ends because it is no simulation of ballast any more.
struct LimitParameters {
  double overlap = 1; // of any contact over the mean radius of a member sphere [-]
};

struct OutputParameters {
  int records = 0;                 // rows of history.csv during the test itself [-]
  int field_frames = 0;            // frames for ParaView during the test itself [-]
  bool report = true;              // draw the figures at the end
  double checkpoint_interval = 60; // of wall-clock time; 0: at the ends of stages only [s]
};

// Opens the sections Limits and Output and declares every member of both, which must outlive the
// table.
void declare_limits_and_output(ParameterTable& table, LimitParameters& limits,
                               OutputParameters& output);
} // namespace interlock::coupling
