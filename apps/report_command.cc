#include "apps/report_command.h"

#include "apps/experiments.h"
#include "apps/parameter_scanner.h"
#include "dem/input_error.h"

#include <array>
#include <stdexcept>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interlock::apps
{
namespace
{
// The interpreter of the system, for which Debian packages Matplotlib and h5py.
constexpr const char* python = "/usr/bin/python3";
constexpr const char* pull_out_script = INTERLOCK_SOURCE_DIR "/apps/figures.py";
constexpr const char* heap_script = INTERLOCK_SOURCE_DIR "/apps/heap_figures.py";
constexpr const char* laboratory_script = INTERLOCK_SOURCE_DIR "/apps/laboratory_figures.py";

// By the experiment in used.prm, which a run writes first of all.
const char* script_for(const std::filesystem::path& folder)
{
  const std::filesystem::path used = folder / "used.prm";
  if (!std::filesystem::is_regular_file(used)) return pull_out_script;
  for (const Assignment& assignment : scan_parameter_file(used).assignments) {
    if (assignment.key() != "Experiment") continue;
    const std::string experiment = present_name(assignment.value);
    if (experiment == "heap") return heap_script;
    if (experiment == "laboratory") return laboratory_script;
  }
  return pull_out_script;
}
} // namespace

int draw_figures(const std::filesystem::path& folder)
{
  // No shell in between, so a folder may have any name.
  const std::string name = folder.string();
  const std::array<const char*, 4> arguments = {python, script_for(folder), name.c_str(), nullptr};
  pid_t child = 0;
  if (posix_spawn(&child, python, nullptr, nullptr, const_cast<char* const*>(arguments.data()),
                  environ) != 0)
    return 127;
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

void add_report_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "report", "Draw the figures of a finished or running simulation into FOLDER/figures.");
  auto folder = std::make_shared<std::string>();
  command->add_option("folder", *folder, "Output folder of \"interlock run\".")->required();
  command->callback([folder] {
    if (!std::filesystem::is_directory(*folder))
      throw InputError("The folder \"" + *folder + "\" does not exist.");
    const int status = draw_figures(*folder);
    if (status == 2) throw InputError("The folder \"" + *folder + "\" holds nothing to draw.");
    if (status != 0)
      throw std::runtime_error("the figures could not be drawn: " + std::string(python) +
                               " with Matplotlib and h5py is needed");
  });
}
} // namespace interlock::apps
