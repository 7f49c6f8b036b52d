#include "coupling/pull_out/pull_out.h"

namespace interlock::coupling
{
StageStatus before_step(FillStage& stage, PullOut& experiment, RunRecords& records)
{
  experiment.drop_lost_stones();
  return fill(stage, experiment.filling(), records);
}
} // namespace interlock::coupling
