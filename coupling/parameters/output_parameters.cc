#include "coupling/parameters/output_parameters.h"

#include <limits>

namespace interlock::coupling
{
void declare_limits_and_output(ParameterTable& table, LimitParameters& limits,
                               OutputParameters& output)
{
  const Range at_least_one{1, std::numeric_limits<double>::infinity(), true};
  table.open_section("Limits");
  table.offer("Overlap", limits.overlap, 1, positive,
              "Overlap of any contact over the mean radius of a member sphere above which the run "
              "ends: a stone is wedged. [-]");

  table.open_section("Output");
  table.offer("Records", output.records, 500, at_least_one,
              "Rows of history.csv during the test itself (the pull, the shearing). [-]");
  table.offer("Field frames", output.field_frames, 50, not_negative,
              "Frames for ParaView during the test itself. [-]");
  table.offer("Report", output.report, true,
              "Draw the figures and write report.html at the end of the run.");
  table.offer(
      "Checkpoint interval", output.checkpoint_interval, 60, not_negative,
      "Wall-clock time between two checkpoints, beside those at the ends of stages; 0: only "
      "those. [s]");
}
} // namespace interlock::coupling
