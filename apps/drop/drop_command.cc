#include "apps/drop/drop_command.h"

#include "apps/build_info.h"
#include "apps/case_hash.h"
#include "apps/drop/finished_pull.h"
#include "apps/drop/force_drop.h"
#include "apps/drop/second_pull.h"
#include "apps/figure_script.h"
#include "coupling/files/atomic_file.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct DropArguments {
  std::string folder;
  double within = DropSearch().within;
};

void check_records(const FinishedPull& run, double within)
{
  const std::string name = "\"" + (run.folder / "history.csv").string() + "\"";
  if (!(within > 0))
    throw InputError(
        fmt::format("The option --within is {:g} m, but must be greater than 0.", within));
  if (within > run.pull.distance)
    throw InputError(
        fmt::format("The option --within is {:g} m, but the whole pull is {:g} m long.", within,
                    run.pull.distance));
  const std::size_t n = run.place.size(), m = run.force.size();
  const double spacing = n > 1 ? run.place.back() / static_cast<double>(n - 1) : 0;
  if (n < 5 || n != m || 4 * spacing > within)
    throw InputError(fmt::format("{} has {} rows that may be used, too few to see a drop within "
                                 "{:g} mm: it takes 5, and one "
                                 "every {:g} mm; run the case with more Output/Records.",
                                 name, std::min(n, m), 1e3 * within, 250 * within));
}

ForceDrop find_drop(const FinishedPull& run, double within)
{
  check_records(run, within);
  DropSearch search;
  search.from = 0.5 * run.pull.speed * run.pull.ramp_time; // way to full speed
  search.within = within;
  const auto drop = largest_drop(run.place, run.force, search);
  if (!drop)
    throw InputError("The pull of \"" + run.folder.string() +
                     "\" has no drop: the force never falls from a maximum.");
  if (!drop->counts)
    throw InputError(
        fmt::format("The pull of \"{}\" has no drop: the largest fall within {:g} mm is from "
                    "{:.3g} N to {:.3g} "
                    "N at {:.2f} mm, less than a tenth of the highest force, {:.3g} N.",
                    run.folder.string(), 1e3 * within, drop->before.force, drop->after.force,
                    1e3 * drop->after.displacement, drop->highest));
  return *drop;
}

// What the second pull is for: drop.json, in which the figure finds its moments.
ordered_json description(const FinishedPull& run, const ForceDrop& drop, double within)
{
  const auto moment = [](const ForceDrop::Moment& m) {
    return ordered_json{{"displacement_m", m.displacement}, {"force_N", m.force}};
  };
  return {{"within_m", within},
          {"before", moment(drop.before)},
          {"during", moment(drop.during)},
          {"after", moment(drop.after)},
          {"parameters_hash", case_hash(run.folder / "used.prm")},
          {"state_hash", run.summary.value("state_hash", "")},
          {"commit", build_commit}};
}

void say_what_comes(const FinishedPull& run, const ForceDrop& drop)
{
  std::cout
      << fmt::format(
             "The largest drop: from {:.0f} N at {:.2f} mm to {:.0f} N at {:.2f} mm. The pull "
             "is made again up to there, for the contacts at these moments.",
             drop.before.force, 1e3 * drop.before.displacement, drop.after.force,
             1e3 * drop.after.displacement)
      << std::endl;
  const std::string commit =
      run.summary.contains("origin") ? run.summary["origin"].value("commit", "") : std::string();
  if (commit != build_commit)
    std::cout << "The run was made by commit " << commit << " of the program, this is "
              << build_commit << ": its digits may be other ones, which ends this." << std::endl;
}

// Up to the row of the minimum.
SecondPull second_pull(const FinishedPull& run, const ForceDrop& drop)
{
  SecondPull pull{run.folder, run.folder / "drop", {}, 0};
  // The last record may lie a step beyond the end.
  for (const ForceDrop::Moment& moment : {drop.before, drop.during, drop.after})
    pull.frames_at.push_back(std::min(moment.displacement, run.pull.distance));
  pull.rows = std::upper_bound(run.place.begin(), run.place.end(), drop.after.displacement) -
              run.place.begin();
  return pull;
}

void draw_drop(const DropArguments& arguments)
{
  const FinishedPull run = read_finished_pull(arguments.folder);
  if (run.unusable_from)
    std::cout << fmt::format("Searched up to {:.2f} mm: from there on the pull is not to be used.",
                             1e3 * *run.unusable_from)
              << std::endl;
  const ForceDrop drop = find_drop(run, arguments.within);
  const SecondPull pull = second_pull(run, drop);
  const ordered_json wanted = description(run, drop, arguments.within);
  const fs::path file = pull.folder / "drop.json";
  if (read_json(file) != wanted) {
    state_before_pull(run.folder); // refuses before anything is said or removed
    say_what_comes(run, drop);
    pull_again(pull);
    std::cout << fmt::format("All {} rows up to there have the digits of the first pull.\n",
                             pull.rows);
    coupling::write_atomically(file, wanted.dump(2) + "\n");
  }
  const ScriptResult result = run_figure_script("drop_figures.py", {arguments.folder});
  if (result.status == 2) throw InputError(result.reason);
  if (result.status != 0)
    throw std::runtime_error("the figure could not be drawn: " + result.reason);
}
} // namespace

void add_drop_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "drop", "Draw the contact forces before, during and after the largest drop of a pull-out "
              "force.");
  auto arguments = std::make_shared<DropArguments>();
  command->add_option("folder", arguments->folder, "Output folder of a finished pull-out.")
      ->required();
  command->add_option(
      "--within", arguments->within,
      "Displacement of the pulled edge in which the force falls; 0.002 if not given. "
      "[m]");
  command->footer(
      "A drop is the fall of the pull-out force from a local maximum, after the ramp of the pull, "
      "to "
      "the lowest value within that displacement, both of the running median over 0.2 mm and three "
      "records at least, so that single records count for nothing; the largest one is drawn, if it "
      "is a tenth of the highest force or more. The pull is made again up to there in FOLDER/drop, "
      "from its state_before_pull.h5, and must have the digits of the first one in every "
      "row.\nFigure: FOLDER/figures/force_drop.png\nExample: interlock drop results/quick\n\nExit "
      "codes: 0 done, 2 the folder is refused or has no drop, 3 the second pull is not the first "
      "one, 130 interrupted.");
  command->callback([arguments] { draw_drop(*arguments); });
}
} // namespace interlock::apps
