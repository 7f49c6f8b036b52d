// The only loop: steps a world through a plan of stages, and keeps its state.
//
// An experiment is a struct with
//   static constexpr const char* name;                  // "pull-out"
//   using Stage = std::variant<...>;                     // coupling/run/stage.h
//   World& world();
//   std::vector<Stage> plan() const;
//   std::vector<std::string> history_columns() const;    // of history.csv
//   PhysicsLimits limits() const;                        // beyond them the run fails
//   void begin(RunRecords&) const;                       // logs what was prepared
//   void finish(std::vector<Stage>& plan, RunRecords&);  // results into the summary
// and a field list `exchange(archive, experiment)` of all that changes, the world included.
// CONTRIBUTING.md shows a complete small one.
#pragma once

#include "coupling/files/atomic_file.h"
#include "coupling/run/checkpoints.h"
#include "coupling/run/physics_limits.h"
#include "coupling/run/run_failure.h"
#include "coupling/run/run_records.h"
#include "coupling/run/run_request.h"
#include "coupling/run/stage.h"
#include "coupling/loop/state_hash.h"
#include "coupling/state/state_archive.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace interlock::coupling
{
// So many steps between two looks at the screen, and between two checks that physics is sane. The
// second one costs about as much as ten steps of a packed box.
constexpr int steps_between_progress = 100, steps_between_checks = 1000;

template <class Experiment> class Run
{
public:
  using Stage = typename Experiment::Stage;

  Run(Experiment& experiment, const RunRequest& request)
      : experiment_(experiment), request_(request),
        records_(request.folder, experiment.history_columns(), request.monitor),
        checkpoints_(request.folder, request.checkpoint_interval, request.version, request.writes),
        plan_(experiment.plan())
  {
    if (!request.writes) records_.keep_to_yourself();
  }

  // All stages to the end; writes history, fields and checkpoints. With several ranks each of them
  // runs this, and does the same but for the stones that it moves. Throws InputError when a
  // checkpoint does not fit, RunFailure when the physics fails or the disk is full, RunStopped when
  // the monitor asks to stop: the state is kept then.
  Summary run()
  {
    begin();
    try {
      while (stage_ < plan_.size()) advance();
      finish();
    } catch (const StopRequested&) {
      throw RunStopped(has_checkpoint(request_.folder) ? checkpoints_.file().string() : "");
    } catch (const RunFailure&) {
      keep_failed_state();
      throw;
    } catch (const WriteError& error) {
      std::string sentence = error.what();
      if (has_checkpoint(request_.folder))
        sentence += "; the last checkpoint is good: make room and go on with --resume";
      throw std::runtime_error(sentence + ".");
    }
    return records_.summary;
  }

private:
  void begin()
  {
    if (request_.resume) {
      resume(checkpoints_.read());
      share();
      return;
    }
    checkpoints_.clear();
    records_.expect(request_.stage_times);
    records_.start();
    experiment_.begin(records_);
    share();
  }

  void share()
  {
    if (request_.ranks) world().share_among(*request_.ranks);
  }

  void resume(const StateTree& state)
  {
    const std::string what = "The checkpoint " + checkpoints_.file().string();
    StateReader archive(state);
    std::string experiment;
    std::vector<CaseEntry> entries;
    archive("experiment", experiment);
    archive("case", entries);
    if (experiment != Experiment::name)
      throw InputError(what + " belongs to an experiment \"" + experiment + "\", not to \"" +
                       Experiment::name + "\".");
    require_same_case(what, entries, request_.entries, [](const std::string& key) {
      return is_among(key, {"Unusual values", "Output/Checkpoint interval", "Output/Report",
                            "Output/Frames at"});
    });
    exchange_run(archive);
    archive.expect_all_read();
    records_.resume();
    records_.message(fmt::format("Going on from {} at t = {:.6g} s, step {}, {}.",
                                 checkpoints_.file().string(), world().clock.time(),
                                 world().clock.step, where()));
  }

  std::string where() const
  {
    if (stage_ == plan_.size()) return "after the last stage";
    const std::string stage =
        std::visit([](const auto& s) { return stage_name(s); }, plan_[stage_]);
    return fmt::format("{} stage \"{}\"", records_.in_stage() ? "in" : "before", stage);
  }

  // One step of the present stage, or its end.
  void advance()
  {
    Stage& stage = plan_[stage_];
    if (!records_.in_stage()) {
      follow_stable_step();
      records_.begin_stage(std::visit([](const auto& s) { return stage_name(s); }, stage),
                           world().clock);
    }
    const StageStatus status =
        std::visit([&](auto& s) { return before_step(s, experiment_, records_); }, stage);
    if (status.finished) {
      end_stage(status.result);
      return;
    }
    world().begin_step(status.look == Look::at_everything);
    world().compute_forces();
    if (status.look != Look::none)
      std::visit([&](auto& s) { look(s, experiment_, records_); }, stage);
    world().move();
    std::visit([&](auto& s) { after_step(s, experiment_, records_); }, stage);

    const bool stop_requested =
        request_.monitor.stop_requested && request_.monitor.stop_requested();
    const World::Wishes wishes = world().agree({stop_requested, checkpoints_.due()});
    if (wishes.stop) stop();
    const std::int64_t step = world().clock.step;
    if (step % steps_between_checks == 0) {
      if (world().keep_below_stable_step())
        records_.message(fmt::format("The contacts have become stiffer: time step {:.3g} us.",
                                     1e6 * world().clock.dt));
      check();
      speak_of_needless_ranks();
    }
    if (step % steps_between_progress == 0)
      records_.progress(status.fraction, world(), stage_ + 1, plan_.size());
    if (wishes.keep) checkpoints_.write(state());
  }

  // A rank looks at its part, and all ranks end when one of them fails.
  void check()
  {
    world().complete_geogrid();
    std::string failure;
    try {
      check_physics(world(), experiment_.limits());
    } catch (const RunFailure& found) {
      failure = found.what();
    }
    failure = world().first_sentence(failure);
    if (!failure.empty()) throw RunFailure(failure);
  }

  // Stages begin with the step that their contacts allow.
  void follow_stable_step()
  {
    const double before = world().clock.dt;
    world().follow_stable_step();
    const double now = world().clock.dt;
    if (std::abs(now - before) > 0.01 * before)
      records_.message(
          fmt::format("Time step {:.3g} us, after {:.3g} us.", 1e6 * now, 1e6 * before));
  }

  void end_stage(const std::string& result)
  {
    check();
    world().make_whole();
    unite();
    const std::string sentence = records_.end_stage(result, world().clock);
    ++stage_;
    const StateTree tree = state();
    if (stage_ < plan_.size()) keep_start_state(tree);
    checkpoints_.write(tree);
    records_.message(sentence);
  }

  // Stages that other runs may start at leave the state before them behind.
  void keep_start_state(const StateTree& tree) const
  {
    const std::string name =
        std::visit([](const auto& s) { return start_state(s); }, plan_[stage_]);
    if (!name.empty()) checkpoints_.write_as(name, tree);
  }

  void stop()
  {
    checkpoints_.write(state());
    wait_for_writer();
    throw RunStopped(checkpoints_.file().string());
  }

  void finish()
  {
    world().make_whole();
    Summary& summary = records_.summary;
    summary.version = request_.version;
    summary.experiment = Experiment::name;
    summary.ranks = world().n_ranks();
    const dem::Clumps& clumps = world().engine.clumps();
    summary.clumps = clumps.size();
    summary.spheres = clumps.n_spheres();
    summary.time_step = world().clock.dt;
    summary.steps = world().clock.step;
    summary.simulated_time = world().clock.time();
    summary.wall_time = records_.wall_time();
    summary.state_hash = state_hash(world());
    experiment_.finish(plan_, records_);
    describe_ranks();
  }

  // Once, as soon as enough was measured.
  void speak_of_needless_ranks()
  {
    constexpr std::int64_t enough = 10000; // steps
    if (spoke_of_ranks_ || world().n_ranks() == 1) return;
    const std::vector<RankTimes> times = world().times();
    if (times.front().steps < enough) return;
    spoke_of_ranks_ = true;
    const BestRanks best = best_number_of_ranks(times);
    if (best.ranks < world().n_ranks())
      records_.message(fmt::format(
          "{} ranks are more than these stones keep busy: by what was measured so far, {} of them "
          "would take about {:.0f} us a step, and all of them {:.0f}.",
          world().n_ranks(), best.ranks, 1e6 * best.best, 1e6 * best.all));
  }

  // What the ranks did with their time.
  void describe_ranks()
  {
    const std::vector<RankTimes> times = world().times();
    for (std::size_t rank = 0; rank < times.size(); ++rank) {
      const RankTimes& t = times[rank];
      const double us = 1e6 / std::max<double>(1, t.steps);
      records_.message(fmt::format(
          "rank {}: {:.0f} stones and {:.0f} ghosts in the mean; a step took {:.1f} us for forces, "
          "{:.1f} us for contacts with ribs, {:.1f} us for the lattice, {:.1f} us for messages and "
          "waiting, {:.1f} us for dealing ({} times) and gathering ({} times)",
          rank, t.clumps, t.ghosts, us * t.forces, us * t.ribs, us * t.lattice, us * t.messages,
          us * t.sharing, t.deals, t.gathers));
    }
  }

  // For finding out why; nothing goes on from it.
  void keep_failed_state()
  {
    try {
      checkpoints_.write_as("state_at_failure.h5", state());
      records_.add_frame(world());
    } catch (const std::exception&) {
      // The sentence of the failure itself matters more than that of a full disk.
    }
    wait_for_writer();
  }

  void unite()
  {
    if (stage_ < plan_.size())
      std::visit([&](auto& s) { unite_notes(s, experiment_); }, plan_[stage_]);
  }

  // The other ranks end together with the one that writes, not before it has done so.
  void wait_for_writer() { world().any(false); }

  StateTree state()
  {
    world().make_whole();
    unite();
    StateTree tree;
    StateWriter archive(tree);
    std::string experiment = Experiment::name;
    archive("experiment", experiment);
    archive("case", request_.entries);
    exchange_run(archive);
    return tree;
  }

  template <class Archive> void exchange_run(Archive& archive)
  {
    archive("next_stage", stage_);
    archive("plan", plan_);
    archive("state", experiment_);
    archive("records", records_);
  }

  World& world() { return experiment_.world(); }

  Experiment& experiment_;
  RunRequest request_;
  RunRecords records_;
  Checkpoints checkpoints_;
  std::vector<Stage> plan_;
  std::size_t stage_ = 0; // index of the present stage in the plan
  bool spoke_of_ranks_ = false;
};
} // namespace interlock::coupling
