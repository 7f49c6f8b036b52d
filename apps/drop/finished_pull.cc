#include "apps/drop/finished_pull.h"

#include "apps/case_hash.h"
#include "apps/parameter_file.h"
#include "apps/study/measures.h"
#include "dem/input_error.h"

#include <algorithm>
#include <fstream>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using nlohmann::ordered_json;

coupling::PullParameters pull_of(const fs::path& folder)
{
  const std::string name = "\"" + folder.string() + "\"";
  if (!fs::is_directory(folder)) throw InputError("The folder " + name + " does not exist.");
  if (fs::is_regular_file(folder / "runs.csv"))
    throw InputError(name + " is a study; give the folder of one of its runs, " +
                     (folder / "runs").string() + "/NAME.");
  if (!fs::is_regular_file(folder / "used.prm"))
    throw InputError(name + " holds no used.prm, so it is not the output folder of a run.");
  require_one_run(folder);
  const RunInput input = read_parameter_file(folder / "used.prm");
  const auto* pull_out = std::get_if<coupling::PullOutParameters>(&input.parameters);
  if (!pull_out)
    throw InputError("The run in " + name + " has no pull: its experiment is \"" +
                     input.experiment->name + "\", not \"pull-out\".");
  return pull_out->pull;
}

// What lies beyond the displacement from which on the pull is not to be used goes.
void leave_out_unusable(FinishedPull& run)
{
  const auto from = run.summary["results"].find("not_usable_from_mm");
  if (from == run.summary["results"].end() || !from->is_number()) return;
  const double end = 1e-3 * from->get<double>();
  const std::size_t rows =
      std::lower_bound(run.place.begin(), run.place.end(), end) - run.place.begin();
  run.place.resize(rows);
  run.force.resize(std::min(rows, run.force.size()));
  run.unusable_from = end;
}
} // namespace

ordered_json read_json(const fs::path& file)
{
  std::ifstream in(file);
  if (!in) return {};
  return ordered_json::parse(in, nullptr, false);
}

FinishedPull read_finished_pull(const fs::path& folder)
{
  FinishedPull run{folder, pull_of(folder), read_json(folder / "summary.json"), {}, {}, {}};
  if (!run.summary.is_object() || !run.summary.contains("results"))
    throw InputError("The run in \"" + folder.string() +
                     "\" is not finished, it has no summary.json: its largest drop may still come; "
                     "wait for it, or go on with \"interlock run ... --resume\".");
  auto history = read_history(folder);
  run.place = history["displacement"];
  run.force = history["pull_force"];
  leave_out_unusable(run);
  return run;
}
} // namespace interlock::apps
