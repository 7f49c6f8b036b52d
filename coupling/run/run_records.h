// What a run writes down: stages, warnings, rows of history.csv, frames for ParaView, results.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/output/field_frames.h"
#include "coupling/output/history.h"
#include "coupling/output/monitor.h"
#include "coupling/output/summary.h"

#include <chrono>
#include <filesystem>
#include <optional>

namespace interlock::coupling
{
class RunRecords
{
public:
  // Writes nothing yet. `folder` must exist by the time of `start` or `resume`.
  RunRecords(std::filesystem::path folder, std::vector<std::string> history_columns,
             Monitor monitor);

  Summary summary; // grows with the run; experiments add results

  // For all ranks but the one that writes: from now on nothing is written.
  void keep_to_yourself() { writes_ = false; }
  bool writes() const { return writes_; }

  // Opens new files, or goes on with those of the run whose records have been read: rows and frames
  // beyond them are cut off. Throws InputError when a file of that run is missing.
  void start();
  void resume();

  void begin_stage(const std::string& name, const StepClock& clock);
  // Returns the sentence for the log, so that the state can be kept before anybody reads it.
  std::string end_stage(const std::string& result, const StepClock& clock);
  // One that made no step: the preparation before the run.
  void add_stage(const std::string& name, const std::string& result, double wall_time);
  bool in_stage() const { return in_stage_; }
  const std::string& stage_name() const { return summary.stages.back().name; }
  void warn(const std::string& sentence);
  void message(const std::string& sentence) const;
  // What the stages will take, for the time left (RunRequest::stage_times).
  void expect(std::vector<double> stage_times) { stage_times_ = std::move(stage_times); }
  // Throws StopRequested when somebody wants the run to stop: for what takes long within a step.
  // The run goes on from its last checkpoint then.
  void throw_if_stop_requested() const;
  // The present stage is the `number`-th, from 1, of `stages`.
  void progress(double fraction, const World& world, std::size_t number, std::size_t stages) const;

  // A row of history.csv, flushed at once.
  void add(const std::vector<History::Cell>& row)
  {
    if (history_) history_->add(row);
  }
  void add_frame(const World& world);

  const std::filesystem::path& folder() const { return folder_; }
  double wall_time() const; // of the run, all parts of a resumed one [s]

  template <class Archive> friend void exchange(Archive& archive, RunRecords& records)
  {
    archive("stages", records.summary.stages);
    archive("warnings", records.summary.warnings);
    exchange_json(archive, "results", records.summary.results);
    archive("contacts", records.summary.contacts);
    archive("in_stage", records.in_stage_);
    archive("stage_begin_step", records.stage_begin_step_);
    archive("stage_begin_time", records.stage_begin_time_, "s");
    double run = records.wall_time(), stage = records.stage_wall_time();
    archive("wall_time", run, "s");
    archive("stage_wall_time", stage, "s");
    records.wall_time_before_ = run, records.stage_wall_time_before_ = stage;
    records.clock_start_ = records.stage_clock_start_ = Clock::now();
    if (!Archive::reading) records.rows_ = records.history_ ? records.history_->rows() : 0;
    archive("rows", records.rows_);
    archive("frames", records.frames_);
    archive("stage_times", records.stage_times_);
  }

private:
  using Clock = std::chrono::steady_clock;

  double stage_wall_time() const;
  // Of stage `number`, from 1: Progress::later_stages.
  double later_stages(std::size_t number) const;
  // JSON numbers are written with the digits that give the same double again.
  template <class Archive>
  static void exchange_json(Archive& archive, const char* name, nlohmann::ordered_json& value)
  {
    std::string text = value.is_null() ? "" : value.dump();
    archive(name, text);
    if (Archive::reading && !text.empty()) value = nlohmann::ordered_json::parse(text);
  }

  std::filesystem::path folder_;
  std::vector<std::string> columns_;
  Monitor monitor_;
  std::optional<History> history_;
  FieldFrames frames_;
  bool writes_ = true;
  std::int64_t rows_ = 0; // of history.csv
  std::vector<double> stage_times_;

  bool in_stage_ = false;
  std::int64_t stage_begin_step_ = 0;
  double stage_begin_time_ = 0;                              // [s]
  double wall_time_before_ = 0, stage_wall_time_before_ = 0; // of earlier processes [s]
  Clock::time_point clock_start_ = Clock::now(), stage_clock_start_ = clock_start_;
};

// Warns when the ledger of the whole run leaves its bound.
void warn_of_ledger(const EnergyLedger& ledger, RunRecords& records);

// The columns of a ledger in history.csv, and its cells.
void append_ledger_columns(std::vector<std::string>& columns);
void append_ledger(std::vector<History::Cell>& row, const EnergyLedger& ledger);

template <class Archive> void exchange(Archive& archive, StageSummary& stage)
{
  archive("name", stage.name);
  archive("steps", stage.steps);
  archive("simulated_time", stage.simulated_time, "s");
  archive("wall_time", stage.wall_time, "s");
}
} // namespace interlock::coupling
