#include "apps/report_command.h"

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
constexpr const char* script = INTERLOCK_SOURCE_DIR "/apps/figures.py";
} // namespace

int draw_figures(const std::filesystem::path& folder)
{
  // No shell in between, so a folder may have any name.
  const std::string name = folder.string();
  const std::array<const char*, 4> arguments = {python, script, name.c_str(), nullptr};
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
