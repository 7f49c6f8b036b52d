#include "apps/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

namespace interlock::apps
{
namespace
{
using Seconds = std::chrono::duration<double>;
constexpr Seconds bar_interval(0.1);
constexpr Seconds line_interval(10);
constexpr int bar_width = 30;
} // namespace

std::string duration_text(const double seconds)
{
  const auto whole = static_cast<long long>(std::llround(std::max(0., seconds)));
  std::ostringstream text;
  if (whole < 60)
    text << whole << " s";
  else if (whole < 3600)
    text << whole / 60 << ':' << std::setw(2) << std::setfill('0') << whole % 60 << " min";
  else
    text << whole / 3600 << ':' << std::setw(2) << std::setfill('0') << whole % 3600 / 60 << " h";
  return text.str();
}

std::string bytes_text(const double bytes)
{
  return bytes < 1e9 ? fmt::format("{:.0f} MB", std::max(1., 1e-6 * bytes))
                     : fmt::format("{:.2g} GB", 1e-9 * bytes);
}

std::string progress_bar(const double fraction, const int width)
{
  const int done = static_cast<int>(std::clamp(fraction, 0., 1.) * width);
  return '[' + std::string(done, '#') + std::string(width - done, '.') + ']';
}

std::string progress_text(const coupling::Progress& progress, const double steps_per_second,
                          const double seconds_left, const double seconds_left_in_all)
{
  std::ostringstream text;
  text << progress.stage;
  if (progress.stages > 0) text << " (" << progress.number << " of " << progress.stages << ')';
  if (progress.fraction >= 0)
    text << ' ' << std::setw(3) << static_cast<int>(100 * std::min(progress.fraction, 1.)) << " %";
  text << ", " << std::fixed << std::setprecision(3) << progress.simulated_time << " s simulated";
  if (steps_per_second > 0) text << ", " << std::setprecision(0) << steps_per_second << " steps/s";
  if (seconds_left >= 0) text << ", " << duration_text(seconds_left) << " left";
  if (seconds_left_in_all >= 0)
    text << ", about " << duration_text(seconds_left_in_all) << " in all";
  return text.str();
}

std::string last_progress(const std::string& log)
{
  // Sentences may hold a per cent, too, but say nothing about simulated time.
  std::size_t end = log.size();
  while (end != std::string::npos && end > 0) {
    const std::size_t newline = log.rfind('\n', end - 1);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const std::string line = log.substr(begin, end - begin);
    const std::size_t sign = line.find(" %, ");
    if (sign != std::string::npos && line.find(" s simulated") != std::string::npos)
      return line.substr(0, sign + 2);
    end = newline;
  }
  return {};
}

std::size_t terminal_line_width()
{
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2)
    return std::numeric_limits<std::size_t>::max();
  return size.ws_col - 1; // a full line would wrap
}

ProgressDisplay::ProgressDisplay(std::ostream& screen, const bool screen_is_terminal,
                                 std::ostream& log, std::function<Clock::time_point()> now,
                                 std::function<std::size_t()> line_width)
    : screen_(screen), terminal_(screen_is_terminal), log_(log), now_(std::move(now)),
      line_width_(std::move(line_width))
{
}

ProgressDisplay::~ProgressDisplay()
{
  clear_bar();
}

void ProgressDisplay::start_stage(const coupling::Progress& progress, const Clock::time_point now)
{
  stage_ = progress.stage;
  stage_start_ = now;
  steps_at_stage_start_ = progress.steps;
  start_phase(progress, now);
  // The first line of a stage comes after a moment, when its speed is known.
  last_line_ = now - std::chrono::duration_cast<Clock::duration>(line_interval - Seconds(1));
}

// What the time left is counted from: a stage may wait several times.
void ProgressDisplay::start_phase(const coupling::Progress& progress, const Clock::time_point now)
{
  phase_start_ = now;
  fraction_at_phase_start_ = last_fraction_ = std::max(0., progress.fraction);
}

void ProgressDisplay::show(const coupling::Progress& progress)
{
  const auto now = now_();
  if (progress.stage != stage_) start_stage(progress, now);
  if (progress.fraction < last_fraction_) start_phase(progress, now);
  last_fraction_ = progress.fraction;
  const bool bar_due = terminal_ && now - last_bar_ > bar_interval;
  const bool line_due = now - last_line_ > line_interval;
  if (!bar_due && !line_due) return;

  const double elapsed = Seconds(now - stage_start_).count();
  const double speed =
      elapsed > 0 ? static_cast<double>(progress.steps - steps_at_stage_start_) / elapsed : 0;
  const double done = progress.fraction - fraction_at_phase_start_;
  // The first per cent says too little: a pull starts slowly.
  const double whole = done > 0.01 ? Seconds(now - phase_start_).count() / done : -1;
  const double left = whole >= 0 ? whole * (1 - progress.fraction) : -1;
  const double in_all =
      whole >= 0 && progress.later_stages > 0 ? left + whole * progress.later_stages : -1;
  const std::string text = progress_text(progress, speed, left, in_all);
  if (line_due) {
    log_ << text << std::endl;
    if (!terminal_) screen_ << text << std::endl;
    last_line_ = now;
  }
  if (bar_due) {
    // Carriage return and `erase to the end of the line`: the bar stays in one place.
    const std::string bar = progress_bar(progress.fraction, bar_width) + ' ' + text;
    screen_ << "\r\033[K" << bar.substr(0, line_width_()) << std::flush;
    bar_visible_ = true;
    last_bar_ = now;
  }
}

void ProgressDisplay::message(const std::string& sentence)
{
  clear_bar();
  screen_ << sentence << std::endl;
  log_ << sentence << std::endl;
}

void ProgressDisplay::clear_bar()
{
  if (bar_visible_) screen_ << "\r\033[K" << std::flush;
  bar_visible_ = false;
}
} // namespace interlock::apps
