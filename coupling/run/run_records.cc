#include "coupling/run/run_records.h"

#include "coupling/run/run_failure.h"

#include <fmt/format.h>

#include <numeric>

namespace interlock::coupling
{
namespace
{
double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
} // namespace

RunRecords::RunRecords(std::filesystem::path folder, std::vector<std::string> history_columns,
                       Monitor monitor)
    : folder_(std::move(folder)), columns_(std::move(history_columns)),
      monitor_(std::move(monitor)), frames_(folder_)
{
}

void RunRecords::start()
{
  if (!writes_) return;
  frames_.start();
  history_.emplace(folder_ / "history.csv", columns_);
}

void RunRecords::resume()
{
  if (!writes_) return;
  history_.emplace(folder_ / "history.csv", columns_, rows_);
  frames_.rewind();
}

void RunRecords::begin_stage(const std::string& name, const StepClock& clock)
{
  summary.stages.push_back({name, 0, 0, 0});
  in_stage_ = true;
  stage_begin_step_ = clock.step;
  stage_begin_time_ = clock.time();
  stage_wall_time_before_ = 0;
  stage_clock_start_ = Clock::now();
}

std::string RunRecords::end_stage(const std::string& result, const StepClock& clock)
{
  StageSummary& stage = summary.stages.back();
  stage.steps = clock.step - stage_begin_step_;
  stage.simulated_time = clock.time() - stage_begin_time_;
  stage.wall_time = stage_wall_time();
  in_stage_ = false;
  return fmt::format("{}: {} ({:.1f} s)", stage.name, result, stage.wall_time);
}

void RunRecords::add_stage(const std::string& name, const std::string& result, double wall_time)
{
  summary.stages.push_back({name, 0, 0, wall_time});
  wall_time_before_ += wall_time;
  message(fmt::format("{}: {} ({:.1f} s)", name, result, wall_time));
}

void RunRecords::warn(const std::string& sentence)
{
  summary.warnings.push_back(sentence);
  message("warning: " + sentence);
}

void RunRecords::throw_if_stop_requested() const
{
  if (monitor_.stop_requested && monitor_.stop_requested()) throw StopRequested();
}

void RunRecords::message(const std::string& sentence) const
{
  if (monitor_.message) monitor_.message(sentence);
}

void RunRecords::progress(double fraction, const World& world, std::size_t number,
                          std::size_t stages) const
{
  if (monitor_.progress)
    monitor_.progress({stage_name(), fraction, world.clock.time(), world.clock.step,
                       static_cast<int>(number), static_cast<int>(stages), later_stages(number),
                       &world});
}

double RunRecords::later_stages(std::size_t number) const
{
  if (number >= stage_times_.size() || !(stage_times_[number - 1] > 0)) return 0;
  return std::accumulate(stage_times_.begin() + number, stage_times_.end(), 0.) /
         stage_times_[number - 1];
}

void RunRecords::add_frame(const World& world)
{
  if (writes_) frames_.write(world.clock.time(), world.engine, world.ribs);
}

double RunRecords::wall_time() const
{
  return wall_time_before_ + seconds_since(clock_start_);
}

double RunRecords::stage_wall_time() const
{
  return in_stage_ ? stage_wall_time_before_ + seconds_since(stage_clock_start_) : 0;
}

void warn_of_ledger(const EnergyLedger& ledger, RunRecords& records)
{
  if (ledger.relative_error() > ledger_bound)
    records.warn(fmt::format(
        "The energy ledger leaves its bound: error {:.2g} of the work put in, bound {:.2g}.",
        ledger.relative_error(), ledger_bound));
}

void append_ledger_columns(std::vector<std::string>& columns)
{
  for (const auto& entry : EnergyLedger().entries())
    columns.push_back("energy_" + entry.first + " [J]");
  columns.push_back("energy_relative_error [-]");
}

void append_ledger(std::vector<History::Cell>& row, const EnergyLedger& ledger)
{
  for (const auto& entry : ledger.entries()) row.push_back(entry.second);
  row.push_back(ledger.relative_error());
}
} // namespace interlock::coupling
