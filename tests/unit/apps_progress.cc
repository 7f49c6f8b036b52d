// What the terminal and the log show. It takes a wrong number, a plain line too many, or control
// characters where there is no terminal, to fail.
#include "apps/progress.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace interlock;

TEST(Progress, TextSaysWhatIsKnown)
{
  EXPECT_EQ(apps::progress_text({"pull", 0.456, 1.2344, 1000}, 52300.4, 83),
            "pull  45 %, 1.234 s simulated, 52300 steps/s, 1:23 min left");
  EXPECT_EQ(apps::progress_text({"stones", -1, 0, 0}, 0, -1), "stones, 0.000 s simulated");
}

TEST(Progress, DurationsReadLikeAClock)
{
  EXPECT_EQ(apps::duration_text(59.4), "59 s");
  EXPECT_EQ(apps::duration_text(59.6), "1:00 min");
  EXPECT_EQ(apps::duration_text(7500), "2:05 h");
}

TEST(Progress, BarIsFullOnlyAtTheEnd)
{
  EXPECT_EQ(apps::progress_bar(0, 4), "[....]");
  EXPECT_EQ(apps::progress_bar(0.99, 4), "[###.]");
  EXPECT_EQ(apps::progress_bar(1, 4), "[####]");
  EXPECT_EQ(apps::progress_bar(-1, 4), "[....]");
  EXPECT_EQ(apps::progress_bar(1.5, 4), "[####]");
}

TEST(Progress, FileGetsSentencesAndNoBar)
{
  std::ostringstream screen, log;
  {
    apps::ProgressDisplay display(screen, false, log);
    for (int step = 0; step < 1000; ++step) display.show({"pull", 1e-3 * step, 1e-6 * step, step});
    display.message("The pull is done.");
  }
  EXPECT_EQ(screen.str(), "The pull is done.\n"); // 1000 steps take less than the first second
  EXPECT_EQ(log.str(), screen.str());
}

TEST(Progress, TerminalGetsABarThatLeavesNoTrace)
{
  std::ostringstream screen, log;
  {
    apps::ProgressDisplay display(screen, true, log);
    display.show({"pull", 0.5, 1, 10});
  }
  EXPECT_NE(screen.str().find("[###############...............] pull  50 %"), std::string::npos);
  EXPECT_EQ(screen.str().substr(screen.str().size() - 4), "\r\033[K"); // the line is erased
  EXPECT_EQ(log.str(), "");
}
