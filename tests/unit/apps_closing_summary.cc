// What a run says at its end and before its beginning. It takes more lines than a small terminal
// has, more than four digits, a result that matters behind one that does not, a table or a sentence
// in a line, a missing path, or a cost that is not the forecast's, to fail.
#include "apps/closing_summary.h"
#include "apps/run_cost.h"
#include "coupling/run/machine_speed.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace interlock;

namespace
{
coupling::Summary pull_out()
{
  coupling::Summary summary;
  summary.experiment = "pull-out";
  summary.clumps = 593, summary.spheres = 32615, summary.steps = 980653;
  summary.wall_time = 51.18901507;
  for (int n = 0; n < 40; ++n) summary.results["something_else_" + std::to_string(n)] = 1. / 3;
  summary.results["list_sizes"] = {{"clump_pairs", 2393}, {"sphere_pairs", 2364}};
  summary.results["not_usable_because"] = std::string(200, 'x');
  summary.results["peak_pull_force_N"] = 837.6052223668357;
  summary.results["displacement_at_peak_m"] = 0.012650191434313986;
  summary.energy["relative_error"] = 0.00045598637087077335;
  summary.warnings = {"One.", "Two."};
  return summary;
}

int lines(const std::string& text)
{
  return 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}
} // namespace

TEST(ClosingSummary, FitsAScreenWithWhatMattersFirst)
{
  const std::string text = apps::closing_summary(pull_out(), "results/quick");
  EXPECT_LE(lines(text), 18); // at most six follow: what was drawn, what to do next
  EXPECT_EQ(text.find("Done: 593 stones of 32615 spheres, 980653 steps in 51 s.\n"
                      "  peak pull force = 837.6 N\n"
                      "  displacement at peak = 12.65 mm\n"
                      "  something else 0 = 0.3333\n"),
            0u)
      << text;
  EXPECT_NE(text.find("error of the energy ledger = 0.046 % of the work"), std::string::npos)
      << text;
  EXPECT_NE(text.find("2 warnings"), std::string::npos) << text;
  // 40, 2 in the table, 1 sentence, 2 of the pull, 1 of the ledger.
  EXPECT_NE(text.find("all 46 numbers, with all their digits: results/quick/summary.json"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("clump_pairs"), std::string::npos) << text;
  EXPECT_EQ(text.find("xxx"), std::string::npos) << text;
  EXPECT_NE(text.find("\nEverything is in results/quick."), std::string::npos) << text;
}

TEST(ClosingSummary, OfAnUnknownExperimentIsInTheOrderOfItsResults)
{
  coupling::Summary summary;
  summary.experiment = "bounce";
  summary.results["bounce_height_m"] = 0.0321;
  EXPECT_NE(apps::closing_summary(summary, "x").find("\n  bounce height = 32.1 mm\n"),
            std::string::npos);
}

class NextStep : public TemporaryFolderTest
{
};

TEST_F(NextStep, IsThePageWhereThereIsOne)
{
  EXPECT_NE(apps::next_step(folder, true).find("interlock report "), std::string::npos);
  EXPECT_NE(apps::next_step(folder, false).find("summary.json"), std::string::npos);
  std::ofstream(folder / "report.html") << "page";
  EXPECT_EQ(apps::next_step(folder, true),
            "Look at it in a browser: " + (folder / "report.html").string());
}

// By hand: 1e6 steps of 2e-6 s with 10000 spheres at 1 ns each are 10 s, twice as long on a slow
// machine; 150 MB and 2 kB a sphere; 11 frames of 42 bytes a sphere and 4 states of 1.5 kB a stone.
TEST(RunCost, IsTheForecastInOneLine)
{
  coupling::Forecast forecast;
  forecast.clumps = 200, forecast.spheres = 10000, forecast.time_step = 2e-6, forecast.frames = 11;
  forecast.stages = {{"settle", 2, 10000, false}};
  EXPECT_NEAR(forecast.time(), 10, 1e-9);
  forecast.slowness = 2;
  EXPECT_EQ(apps::cost_text(forecast, 1),
            "About 20 s at the present speed of this machine, 170 MB of memory, 6 MB of files (11 "
            "frames of 0.42 MB); estimates, good to a factor of two for hundreds of stones.");
  EXPECT_NE(apps::cost_text(forecast, 4).find("for 4 ranks to share"), std::string::npos);
  EXPECT_EQ(apps::cost_text({}, 1), "");
}

// What is measured is a time of this machine: between a hundredth of the reference's and, where
// many others work, a thousand times that.
TEST(RunCost, IsMeasured)
{
  coupling::Forecast forecast;
  coupling::measure_machine(forecast);
  EXPECT_GT(forecast.slowness, 0.01);
  EXPECT_LT(forecast.slowness, 1000);
  EXPECT_GT(forecast.program_memory, 1e6);
  EXPECT_LT(forecast.program_memory, 1e10);
}
