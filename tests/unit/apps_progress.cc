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
  EXPECT_EQ(
      apps::progress_text({"fill", 0.5, 1, 1000, 1, 6}, 100, 10, 130),
      "fill (1 of 6)  50 %, 1.000 s simulated, 100 steps/s, 10 s left, about 2:10 min in all");
  EXPECT_EQ(apps::progress_text({"stones", -1, 0, 0}, 0, -1), "stones, 0.000 s simulated");
  EXPECT_EQ(apps::progress_text({"pull", 0.456, 1.2344, 1000, 5, 6}, 0, -1),
            "pull (5 of 6)  45 %, 1.234 s simulated");
}

TEST(Progress, IsReadOffALog)
{
  const std::string line = apps::progress_text({"pull", 0.456, 1.2344, 1000, 5, 6}, 52300, 83);
  const std::string stones = "stones: 6 stones, volume -0.5 to +0.5 % of that of their stones\n";
  EXPECT_EQ(apps::last_progress(stones + "fill (1 of 6)  50 %, 1.000 s simulated\n" + line + '\n' +
                                "warning: the surface is off by 3 %, which is much.\n"),
            "pull (5 of 6)  45 %");
  EXPECT_EQ(apps::last_progress(line), "pull (5 of 6)  45 %");
  EXPECT_EQ(apps::last_progress(stones), "");
  EXPECT_EQ(apps::last_progress(""), "");
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

namespace
{
// A clock that stands still until the test moves it on.
struct StoppedClock {
  std::chrono::steady_clock::time_point time{std::chrono::hours(1)};
  void wait(double seconds)
  {
    time += std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(seconds));
  }
};
} // namespace

// The first line comes a second after the stage has begun, the next ones 10 s apart.
TEST(Progress, FileGetsSentencesAndNoBar)
{
  std::ostringstream screen, log;
  StoppedClock clock;
  {
    apps::ProgressDisplay display(screen, false, log, [&clock] { return clock.time; });
    const auto show_thousand = [&display](double seconds, int steps) {
      for (int n = 0; n < 1000; ++n) display.show({"pull", 0.25, seconds, steps});
    };
    display.show({"pull", 0, 0, 0});
    clock.wait(0.9);
    show_thousand(0.1, 900);
    EXPECT_EQ(screen.str(), "");
    clock.wait(0.2);
    show_thousand(0.5, 1100);
    const std::string first = "pull  25 %, 0.500 s simulated, 1000 steps/s, 3 s left\n";
    EXPECT_EQ(screen.str(), first);
    clock.wait(9.9);
    show_thousand(1, 5500);
    EXPECT_EQ(screen.str(), first);
    clock.wait(0.2);
    show_thousand(2, 5600);
    display.message("The pull is done.");
    EXPECT_EQ(screen.str(), first + "pull  25 %, 2.000 s simulated, 500 steps/s, 34 s left\n"
                                    "The pull is done.\n");
  }
  EXPECT_EQ(log.str(), screen.str());
}

// A quarter of a stage takes 2 s; those that follow are expected to take five times as long as it.
TEST(Progress, CountsLaterStages)
{
  std::ostringstream screen, log;
  StoppedClock clock;
  apps::ProgressDisplay display(screen, false, log, [&clock] { return clock.time; });
  display.show({"fill", 0, 0, 0, 1, 3, 5});
  clock.wait(2);
  display.show({"fill", 0.25, 0.5, 2000, 1, 3, 5});
  EXPECT_EQ(screen.str(), "fill (1 of 3)  25 %, 0.500 s simulated, 1000 steps/s, 6 s left, about "
                          "46 s in all\n");
}

TEST(Progress, BarIsCutToTheTerminal)
{
  std::ostringstream screen, log;
  StoppedClock clock;
  apps::ProgressDisplay display(
      screen, true, log, [&clock] { return clock.time; }, [] { return std::size_t(40); });
  display.show({"pull", 0.5, 1, 10});
  EXPECT_EQ(screen.str(), "\r\033[K[###############...............] pull  5");
}

TEST(Progress, TerminalGetsABarThatLeavesNoTrace)
{
  std::ostringstream screen, log;
  StoppedClock clock;
  {
    apps::ProgressDisplay display(screen, true, log, [&clock] { return clock.time; });
    display.show({"pull", 0.5, 1, 10});
    const std::string once = screen.str();
    EXPECT_NE(once.find("[###############...............] pull  50 %"), std::string::npos);
    clock.wait(0.05);
    display.show({"pull", 0.6, 1, 11});
    EXPECT_EQ(screen.str(), once); // ten bars a second are enough
    clock.wait(0.06);
    display.show({"pull", 0.7, 1, 12});
    EXPECT_NE(screen.str().find("pull  70 %"), std::string::npos);
  }
  EXPECT_EQ(screen.str().substr(screen.str().size() - 4), "\r\033[K"); // the line is erased
  EXPECT_EQ(log.str(), "");
}
