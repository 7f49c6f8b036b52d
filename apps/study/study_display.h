// The whole study on the terminal: a bar, and a line for each run that ends; the lines in run.log,
// too.
#pragma once

#include "apps/study/outlook.h"

#include <chrono>
#include <fstream>

namespace interlock::apps
{
class StudyDisplay
{
public:
  StudyDisplay(const Plan& plan, const Outlook& outlook, int slots,
               const std::filesystem::path& log);
  ~StudyDisplay();
  StudyDisplay(const StudyDisplay&) = delete;
  StudyDisplay& operator=(const StudyDisplay&) = delete;

  void message(const std::string& sentence);
  void started(int task);
  void ended(int task, bool well, const std::string& sentence);
  void show(); // the bar, twice a second at most

private:
  void clear_bar();
  std::string text() const;
  std::string runs_under_way() const;

  const Plan& plan_;
  const Outlook& outlook_;
  std::ofstream log_;
  bool terminal_, bar_visible_ = false;
  std::chrono::steady_clock::time_point last_bar_, start_;
  int slots_, over_ = 0, failed_ = 0;
  std::vector<int> running_; // tasks, in the order in which they were started
  double time_of_over_ = 0, time_of_all_ = 0, time_at_start_ = 0; // processor time [s]
};
} // namespace interlock::apps
