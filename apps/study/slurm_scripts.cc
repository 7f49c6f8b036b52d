#include "apps/study/slurm_scripts.h"

#include "apps/output_folder.h"
#include "apps/shell_word.h"
#include "coupling/files/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

// Asked for beside what is forecast, since that is good to a factor of two.
constexpr double time_factor = 4, least_time = 600; // [s]
constexpr int memory_megabytes = 1000;              // of a rank

struct Array {
  int first, last; // numbers of the plan
};

std::string head(const Plan& plan, const std::string& name, const std::string& output, double time)
{
  const long minutes = std::lround(std::ceil((least_time + time_factor * time) / 60));
  return fmt::format("#!/bin/bash\n"
                     "#SBATCH --job-name={}\n"
                     "#SBATCH --output={}\n"
                     "#SBATCH --time={}\n"
                     "#SBATCH --mem-per-cpu={}M\n"
                     "#SBATCH --requeue\n"
                     // The run keeps its state before the time is over.
                     "#SBATCH --signal=B:TERM@60\n",
                     name, (plan.folder / "slurm" / output).string(), minutes, memory_megabytes);
}

// The program and the study, as words of the shell.
std::string command(const Plan& plan)
{
  return "exec " + shell_word(fs::read_symlink("/proc/self/exe").string()) + " study " +
         shell_word(fs::absolute(plan.study.file).string()) + " -o " +
         shell_word(plan.folder.string());
}

std::string array_script(const Plan& plan, const Outlook& outlook, const std::string& name,
                         Array array, int at_once)
{
  double time = 0;
  for (int k = array.first; k <= array.last; ++k) time = std::max(time, outlook.tasks[k].time);
  std::string text = head(plan, name, name + "_%a.txt", time / plan.study.ranks_per_run);
  text += fmt::format("#SBATCH --ntasks={}\n#SBATCH --array={}-{}{}\n", plan.study.ranks_per_run,
                      array.first, array.last, at_once > 0 ? fmt::format("%{}", at_once) : "");
  return text + command(plan) + " --task \"$SLURM_ARRAY_TASK_ID\"\n";
}
} // namespace

fs::path write_slurm_scripts(const Plan& plan, const Outlook& outlook, int at_once)
{
  const fs::path folder = plan.folder / "slurm";
  create_output_folder(folder);
  const int n = static_cast<int>(plan.tasks.size());
  std::string submit = "#!/bin/bash\n# Submits the study; a run that is over is not made again.\n"
                       "set -euo pipefail\ncd \"$(dirname \"$0\")\"\n";
  std::string after;
  const auto add = [&](const std::string& name, const std::string& text) {
    coupling::write_atomically(folder / (name + ".sh"), text);
    submit += name + "=$(sbatch --parsable" + after + " " + name + ".sh)\n";
    after = " --dependency=afterany:\"$" + name + "\"";
  };
  if (plan.n_states > 0)
    add("states", array_script(plan, outlook, "states", {0, plan.n_states - 1}, at_once));
  add("runs", array_script(plan, outlook, "runs", {plan.n_states, n - 1}, at_once));
  add("collect", head(plan, "collect", "collect.txt", 0) + command(plan) + " --collect\n");
  submit += "echo \"The results will be there when job $collect has ended.\"\n";
  coupling::write_atomically(folder / "submit.sh", submit);
  return folder / "submit.sh";
}
} // namespace interlock::apps
