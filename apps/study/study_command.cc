#include "apps/study/study_command.h"

#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/output_folder.h"
#include "apps/ranks.h"
#include "apps/run_folder.h"
#include "apps/shell_word.h"
#include "apps/study/schedule.h"
#include "apps/study/slurm_scripts.h"
#include "apps/study/study_conclusion.h"
#include "apps/study/study_display.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <numeric>

#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

struct StudyArguments {
  std::string file, output;
  int jobs = 1, task = -1;
  bool jobs_given = false, check = false, slurm = false, collect = false, force = false;
};

// Runs of another study or of another program are not taken for those of this one.
void refuse_foreign_runs(const Plan& plan, const std::vector<RunInput>& inputs, bool force)
{
  std::error_code error;
  if (fs::exists(plan.folder / "used.prm", error))
    throw InputError("The output folder \"" + plan.folder.string() +
                     "\" holds a single run; choose another one with --output.");
  for (std::size_t k = 0; k < plan.tasks.size(); ++k) {
    const TaskFolder folder(plan, plan.tasks[k]);
    const std::string why = folder.why_foreign(inputs[k].used);
    if (why.empty()) continue;
    if (!force)
      throw InputError(why + "; --force makes such runs anew, --output NAME writes elsewhere.");
    folder.forget();
  }
}

Outlook look_ahead_on_terminal(const Plan& plan, const std::vector<RunInput>& inputs)
{
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  Outlook outlook = look_ahead(plan, inputs, [&](int done, int all) {
    if (terminal) std::cout << fmt::format("\rChecking {} of {} ", done + 1, all) << std::flush;
  });
  if (terminal) std::cout << "\r\033[K" << std::flush;
  return outlook;
}

ScheduleEvents events_of(StudyDisplay& display)
{
  return {[&](int task) { display.started(task); },
          [&](int task, bool well, const std::string& sentence) {
            display.ended(task, well, sentence);
          },
          [&] { display.show(); }};
}

// One run of the plan, for a job array.
void run_one(const Plan& plan, const std::vector<RunInput>& inputs, int task)
{
  if (task >= static_cast<int>(plan.tasks.size()))
    throw InputError(
        fmt::format("--task is {}, but the tasks of this study have the numbers 0 to {}.", task,
                    plan.tasks.size() - 1));
  const TaskFolder folder(plan, plan.tasks[task]);
  folder.write_case(inputs[task].used);
  std::vector<Slot> slots = local_slots(plan, 1);
  bool good = folder.is_over();
  std::string why;
  run_tasks(plan, {task}, slots,
            {[](int) {},
             [&](int, bool well, const std::string& sentence) {
               good = well;
               why = sentence;
             },
             [] {}});
  if (!good) throw std::runtime_error(plan.tasks[task].name + ": " + why);
  std::cout << plan.tasks[task].name << " is done.\n";
}

// On the first rank, while the others serve.
void run_all(const Plan& plan, std::vector<Slot> slots, StudyDisplay& display)
{
  std::vector<int> tasks(plan.tasks.size());
  std::iota(tasks.begin(), tasks.end(), 0);
  try {
    run_tasks(plan, tasks, slots, events_of(display));
  } catch (const Interrupted&) {
    write_results(read_runs(plan));
    throw;
  }
}

int slots_of(const Plan& plan, const StudyArguments& arguments)
{
  const int size = all_ranks().size();
  if (size == 1) return arguments.jobs;
  if (size < plan.study.ranks_per_run)
    throw InputError(fmt::format("mpirun started {} ranks, but \"Ranks per run\" is {}.", size,
                                 plan.study.ranks_per_run));
  return size / plan.study.ranks_per_run;
}

void check_arguments(const StudyArguments& a)
{
  const int size = all_ranks().size();
  if (size > 1 && (a.jobs_given || a.check || a.slurm || a.collect || a.task >= 0))
    throw InputError(
        "Under mpirun a study takes none of --jobs, --check, --slurm, --collect and --task: the "
        "ranks are its jobs.");
}

// What a study needs beside its plan; the first rank has it.
struct Preparation {
  std::unique_ptr<RunFolder> owner;
  Outlook outlook;
  std::unique_ptr<StudyDisplay> display;

  void say(const std::string& sentence) const
  {
    if (display)
      display->message(sentence);
    else
      std::cout << sentence << std::endl;
  }
};

// Refuses what cannot be, says what will be, and takes the folder. Nothing is written before.
void prepare(const Plan& plan, const std::vector<RunInput>& inputs, const StudyArguments& arguments,
             int slots, Preparation& made)
{
  const bool runs_all = arguments.task < 0 && !arguments.collect && !arguments.check;
  check_output_folder(plan.folder);
  if (runs_all) made.owner = std::make_unique<RunFolder>(plan.folder, FolderUse::resume);
  refuse_foreign_runs(plan, inputs, arguments.force && !arguments.check);
  if (arguments.task >= 0 || arguments.collect) return;
  made.outlook = look_ahead_on_terminal(plan, inputs);
  std::cout << announcement(plan, made.outlook, slots) << std::endl;
  if (arguments.check) return;
  made.owner->take();
  for (std::size_t k = 0; k < plan.tasks.size(); ++k)
    TaskFolder(plan, plan.tasks[k]).write_case(inputs[k].used);
  made.display = std::make_unique<StudyDisplay>(plan, made.outlook, slots, plan.folder / "run.log");
}

// On all ranks; what ends the runs, ends all of them alike.
void run_and_conclude(const Plan& plan, int slots, Preparation& made)
{
  std::exception_ptr failure;
  if (all_ranks().rank() > 0) {
    serve(plan);
  } else {
    try {
      run_all(plan, all_ranks().size() > 1 ? slots_of_ranks(plan) : local_slots(plan, slots),
              *made.display);
    } catch (...) {
      failure = std::current_exception();
    }
    dismiss_servers();
  }
  on_first_rank([&] {
    if (failure) std::rethrow_exception(failure);
    conclude(plan, [&](const std::string& sentence) { made.say(sentence); });
  });
}

void study(const StudyArguments& arguments)
{
  const StudyFile file = read_study_file(arguments.file);
  const Plan plan = make_plan(file, arguments.output.empty() ? default_output_folder(arguments.file)
                                                             : fs::path(arguments.output));
  const std::vector<RunInput> inputs = read_tasks(plan);
  start_mpi();
  catch_interruption();
  check_arguments(arguments);
  const int slots = slots_of(plan, arguments);
  Preparation made;
  on_first_rank([&] { prepare(plan, inputs, arguments, slots, made); });
  if (arguments.check) return;
  if (arguments.task >= 0) {
    run_one(plan, inputs, arguments.task);
  } else if (arguments.collect) {
    conclude(plan, [&](const std::string& sentence) { made.say(sentence); });
  } else if (arguments.slurm) {
    const int at_once = arguments.jobs_given ? arguments.jobs : 0;
    made.say("To submit the study: bash " +
             shell_word(write_slurm_scripts(plan, made.outlook, at_once).string()));
  } else {
    run_and_conclude(plan, slots, made);
  }
}
} // namespace

void add_study_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "study", "Make the runs that a study file describes, several at a time, and compare them.");
  auto arguments = std::make_shared<StudyArguments>();
  command
      ->add_option("file", arguments->file,
                   "Study file (.prm); docs/studies.md says what is in it.")
      ->required();
  command->add_option("-o,--output", arguments->output,
                      "Folder of the study; results/NAME for a file NAME.prm if not given.");
  CLI::Option* jobs =
      command->add_option("--jobs", arguments->jobs, "Runs at a time; 1 if not given.")
          ->check(CLI::Range(1, 10000));
  command->add_flag("--check,--dry-run", arguments->check,
                    "Check every combination and say what the study would take, without a run.");
  command->add_flag(
      "--slurm", arguments->slurm,
      "Write job arrays for Slurm into FOLDER/slurm instead of running anything; with --jobs N "
      "no more than N at a time.");
  command
      ->add_option("--task", arguments->task,
                   "One run alone, by its number in the plan (job arrays).")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--collect", arguments->collect,
                    "Results and figures of the runs that are there.");
  command->add_flag("--force", arguments->force,
                    "Make runs anew that were made with other entries or by another program.");
  command->footer("A study that was interrupted or killed goes on when the same command is given "
                  "again. Under mpirun "
                  "the ranks are its jobs.\nExample: interlock study "
                  "cases/studies/quick_flexibility.prm --jobs 2\n\nExit codes: 0 "
                  "all runs are done, 2 the input is refused, 3 a run failed or is not to be used, "
                  "130 interrupted.");
  command->callback([arguments, jobs] {
    arguments->jobs_given = jobs->count() > 0;
    study(*arguments);
  });
}
} // namespace interlock::apps
