#include "apps/figure_script.h"

#include "apps/interruption.h"
#include "apps/shared_files.h"

#include <boost/algorithm/string.hpp>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* python = "/usr/bin/python3";

ScriptResult not_found(const fs::path& file)
{
  if (!file.is_absolute())
    return {127, "the script " + file.filename().string() +
                     " cannot be found, since no folder share/interlock is beside the program; "
                     "name one in the environment variable INTERLOCK_SHARE."};
  return {127, "the script " + file.string() +
                   " does not exist; install the program again, or name its folder share/interlock "
                   "in the environment variable INTERLOCK_SHARE."};
}

// What finding files takes, and a language in which every name of a folder can be printed.
std::vector<std::string> own_environment()
{
  std::vector<std::string> variables = {"LC_ALL=C.UTF-8"};
  for (const char* name : {"HOME", "PATH", "TMPDIR", "XDG_CACHE_HOME"})
    if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& words)
{
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

// What the script says until it ends. An interrupt that only this program has heard of ends it.
std::string listen(const int descriptor, const pid_t script)
{
  constexpr int look_every = 100; // [ms]
  std::string text;
  bool told = false;
  char buffer[4096];
  for (;;) {
    pollfd end{descriptor, POLLIN, 0};
    const int ready = poll(&end, 1, look_every);
    if (is_interrupted() && !told) told = kill(script, SIGTERM) == 0;
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t n = read(descriptor, buffer, sizeof buffer);
    if (n > 0) text.append(buffer, n);
    if (n == 0 || (n < 0 && errno != EINTR)) return text;
  }
}

// Starts the interpreter with the writing end of `pipe` as its error output; what posix_spawn says.
int start(std::vector<std::string> arguments, const int (&pipe)[2], bool quiet, pid_t& child)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (quiet) posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  std::vector<std::string> variables = own_environment();
  const int error = posix_spawn(&child, python, &actions, nullptr, pointers(arguments).data(),
                                pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// A traceback ends with what went wrong.
std::string last_line(const std::string& text)
{
  const std::string trimmed = boost::trim_copy(text);
  const auto newline = trimmed.rfind('\n');
  return newline == std::string::npos ? trimmed : trimmed.substr(newline + 1);
}

std::string sentence(std::string text)
{
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}
} // namespace

ScriptResult run_figure_script(const std::string& script, const std::vector<std::string>& arguments,
                               const bool quiet)
{
  const fs::path file = shared_folder() / "apps" / script;
  std::error_code error_of_file;
  if (!fs::is_regular_file(file, error_of_file)) return not_found(file);
  std::vector<std::string> command = {python, "-I", file.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC) != 0) return {127, sentence(std::strerror(errno))};
  std::cout.flush();
  pid_t child = 0;
  const int error = start(command, pipe, quiet, child);
  close(pipe[1]);
  const std::string said = error == 0 ? listen(pipe[0], child) : "";
  close(pipe[0]);
  if (error != 0)
    return {127, std::string(python) + " cannot be started: " + sentence(std::strerror(error))};

  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    return {1, script + " was ended by signal " + std::to_string(WTERMSIG(status)) + "."};
  const int code = WEXITSTATUS(status);
  if (code == 0) std::cerr << said;
  if (code == 0 || code == 2) return {code, code == 0 ? "" : sentence(last_line(said))};
  return {code, last_line(said) + " (all of it: " + boost::join(command, " ") + ")."};
}
} // namespace interlock::apps
