// Runs whose physics leaves its limits, through the program itself: one sentence, exit code 3, the
// last state kept, no summary that could be taken for a result.
#include "tests/stopped_run.h"

using namespace stopped_run;

namespace
{
class PhysicsFailure : public StoppedRunTest
{
};
} // namespace

TEST_F(PhysicsFailure, ARibThatBreaksEndsTheRun)
{
  expect_sentence(run(pull_out("run", {"Geogrid/Break strain=1e-6"})), 3,
                  {"rib breaks", "t = ", " s (step ", "element ", "Geogrid/Break strain"});
  EXPECT_TRUE(fs::is_regular_file(folder / "run/state_at_failure.h5"));
  EXPECT_FALSE(fs::exists(folder / "run/summary.json"));
  EXPECT_NE(text_of(folder / "run/run.log").find("Stopped: A rib breaks"), std::string::npos);
}

TEST_F(PhysicsFailure, AnOverlapBeyondItsLimitEndsTheRun)
{
  expect_sentence(run(pull_out("run", {"Limits/Overlap=1e-6"})), 3,
                  {"overlap", "stone", "t = ", " s (step ", "limit"});
  EXPECT_TRUE(fs::is_regular_file(folder / "run/state_at_failure.h5"));
  EXPECT_FALSE(fs::exists(folder / "run/summary.json"));
}
