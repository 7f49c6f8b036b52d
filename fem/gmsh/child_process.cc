#include "fem/gmsh/child_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interlock::fem
{
namespace
{
// First byte of what a child says.
constexpr char returned = 'r', threw = 't';

// A crash shall end the child and nothing else: PETSc's handlers would end all ranks, the C library
// would say on the terminal what it thinks of the heap, and there is nothing to learn from a core
// file.
void die_quietly_of_signals()
{
  setenv("LIBC_FATAL_STDERR_", "1", 1); // not past the standard streams
  const int nowhere = open("/dev/null", O_WRONLY);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

// False when the reader has gone.
bool write_all(int file, const std::string& bytes)
{
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    done += n;
  }
  return true;
}

std::string read_all(int file)
{
  std::string bytes;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t n = read(file, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.append(buffer, n);
  }
}

[[noreturn]] void be_the_child(const std::function<std::string()>& work, int out)
{
  die_quietly_of_signals();
  std::string said;
  try {
    said = returned + work();
  } catch (const std::exception& error) {
    said = std::string(1, threw) + error.what();
  }
  // Neither destructors nor buffers: they belong to the parent.
  _exit(write_all(out, said) ? EXIT_SUCCESS : EXIT_FAILURE);
}

bool ended_well(pid_t child)
{
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}
} // namespace

std::string in_child_process(const std::function<std::string()>& work, const std::string& crash)
{
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "No pipe");
  const pid_t child = fork();
  if (child < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(error, std::generic_category(), "No child process");
  }
  if (child == 0) {
    close(ends[0]);
    be_the_child(work, ends[1]);
  }
  close(ends[1]);
  const std::string said = read_all(ends[0]);
  close(ends[0]);
  if (!ended_well(child) || said.empty()) throw std::runtime_error(crash);
  if (said.front() == threw) throw std::runtime_error(said.substr(1));
  return said.substr(1);
}
} // namespace interlock::fem
