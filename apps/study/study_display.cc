#include "apps/study/study_display.h"

#include "apps/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds bar_interval(500);
constexpr int bar_width = 30;
} // namespace

StudyDisplay::StudyDisplay(const Plan& plan, const Outlook& outlook, int slots,
                           const std::filesystem::path& log)
    : plan_(plan), outlook_(outlook), log_(log, std::ios::app),
      terminal_(isatty(STDOUT_FILENO) != 0), start_(Clock::now()), slots_(slots)
{
  for (std::size_t k = 0; k < plan.tasks.size(); ++k) {
    time_of_all_ += outlook.tasks[k].time;
    if (!TaskFolder(plan, plan.tasks[k]).is_over()) continue;
    ++over_;
    time_of_over_ += outlook.tasks[k].time;
  }
  time_at_start_ = time_of_over_;
}

StudyDisplay::~StudyDisplay()
{
  clear_bar();
}

void StudyDisplay::clear_bar()
{
  if (bar_visible_) std::cout << "\r\033[K" << std::flush;
  bar_visible_ = false;
}

void StudyDisplay::message(const std::string& sentence)
{
  clear_bar();
  std::cout << sentence << std::endl;
  log_ << sentence << std::endl;
}

void StudyDisplay::started(int task)
{
  if (std::count(running_.begin(), running_.end(), task) == 0) running_.push_back(task);
}

void StudyDisplay::ended(int task, bool well, const std::string& sentence)
{
  const Task& mine = plan_.tasks[task];
  running_.erase(std::remove(running_.begin(), running_.end(), task), running_.end());
  ++over_;
  failed_ += well ? 0 : 1;
  time_of_over_ += outlook_.tasks[task].time;
  const auto summary = TaskFolder(plan_, mine).summary();
  std::string how = "failed";
  if (summary.is_object())
    how = (well ? "done in " : "not to be used, after ") +
          duration_text(summary.value("wall_time_s", 0.));
  message(fmt::format("{} of {}: {} {}{}", over_, plan_.tasks.size(), mine.folder.string(), how,
                      well ? "." : ": " + sentence));
}

std::string StudyDisplay::text() const
{
  const double here = std::chrono::duration<double>(Clock::now() - start_).count();
  const double made = time_of_over_ - time_at_start_, left = time_of_all_ - time_of_over_;
  // Nothing is known of this machine before the first run has ended.
  const double expected = made > 0 ? left * here / made : left / slots_;
  return fmt::format("{} {} of {} runs, {} under way{}, {} left",
                     progress_bar(time_of_all_ > 0 ? time_of_over_ / time_of_all_ : 0, bar_width),
                     over_, plan_.tasks.size(), running_.size(),
                     failed_ > 0 ? fmt::format(", {} failed", failed_) : "",
                     duration_text(expected)) +
         runs_under_way();
}

// Of the first few: a terminal has one line, and a log is a file on the disk that runs share.
std::string StudyDisplay::runs_under_way() const
{
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, running_.size()); ++k) {
    const Task& task = plan_.tasks[running_[k]];
    const std::string progress = TaskFolder(plan_, task).progress_of_log();
    text += "; " + task.name + (progress.empty() ? "" : ": " + progress);
  }
  return text;
}

void StudyDisplay::show()
{
  const auto now = Clock::now();
  if (!terminal_ || now - last_bar_ < bar_interval) return;
  last_bar_ = now;
  std::cout << '\r' << text().substr(0, terminal_line_width()) << "\033[K" << std::flush;
  bar_visible_ = true;
}
} // namespace interlock::apps
