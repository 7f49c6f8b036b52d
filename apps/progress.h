// What a run shows while it works: a bar on a terminal, a plain line now and then elsewhere, and
// the same plain lines in run.log.
#pragma once

#include "coupling/output/monitor.h"

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

namespace interlock::apps
{
// "pull (5 of 6)  45 %, 1.234 s simulated, 52300 steps/s, 1:23 min left, about 4:00 min in all":
// parts that nobody can tell are left out (negative fraction, no speed yet, negative seconds). The
// first time left is that of the stage, the second one that of the run, given where later stages
// are expected to take some.
std::string progress_text(const coupling::Progress& progress, double steps_per_second,
                          double seconds_left, double seconds_left_in_all = -1);

// The beginning of the last such text with a fraction that the plain lines of a log hold: "pull (5
// of 6)  45 %"; empty where they hold none.
std::string last_progress(const std::string& log);

// "[#####.....]" with `width` places; fraction 0 to 1.
std::string progress_bar(double fraction, int width);

// "12 s", "1:23 min", "2:05 h".
std::string duration_text(double seconds);

// "64 MB", "1.3 GB"; at least a megabyte.
std::string bytes_text(double bytes);

// Characters that fit into a line of the terminal on the standard output; no end without one.
std::size_t terminal_line_width();

class ProgressDisplay
{
public:
  // `log` receives every message and a plain line about every 10 s of wall time. Both streams must
  // outlive the display. `now` and `line_width` are there for tests.
  using Clock = std::chrono::steady_clock;
  ProgressDisplay(std::ostream& screen, bool screen_is_terminal, std::ostream& log,
                  std::function<Clock::time_point()> now = Clock::now,
                  std::function<std::size_t()> line_width = terminal_line_width);
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const coupling::Progress& progress);
  void message(const std::string& sentence);

private:
  void start_stage(const coupling::Progress& progress, Clock::time_point now);
  void start_phase(const coupling::Progress& progress, Clock::time_point now);
  void clear_bar();

  std::ostream& screen_;
  bool terminal_;
  std::ostream& log_;
  std::function<Clock::time_point()> now_;
  std::function<std::size_t()> line_width_; // a longer bar is cut
  bool bar_visible_ = false;
  std::string stage_;
  Clock::time_point stage_start_, phase_start_, last_bar_, last_line_;
  std::int64_t steps_at_stage_start_ = 0;
  double fraction_at_phase_start_ = 0, last_fraction_ = 0;
};
} // namespace interlock::apps
