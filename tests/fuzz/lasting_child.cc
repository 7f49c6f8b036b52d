// fem::in_child_process() for the fuzzer: the child stays and does its work again for the next
// file, until it crashes or has done so many. A new process for each file takes twenty times as
// long as reading it. The program itself starts a new one for each (fem/gmsh/child_process.cc,
// which this stands in for).
#include "fem/gmsh/child_process.h"

#include <gmsh.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace interlock::fem
{
namespace
{
constexpr int files_of_a_child = 2000;
constexpr char returned = 'r', threw = 't';

bool write_all(int file, const char* bytes, std::size_t size)
{
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = write(file, bytes + done, size - done);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

bool read_all(int file, char* bytes, std::size_t size)
{
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = read(file, bytes + done, size - done);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

[[noreturn]] void be_the_child(const std::function<std::string()>& work, int in, int out)
{
  const int nowhere = open("/dev/null", O_WRONLY);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM})
    std::signal(signal, SIG_DFL);
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  char request;
  while (read_all(in, &request, 1)) {
    std::string said;
    try {
      said = returned + work();
    } catch (const std::exception& error) {
      said = std::string(1, threw) + error.what();
    }
    // Clearing is not enough: the next file would look empty.
    gmsh::finalize();
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    const std::uint64_t size = said.size();
    if (!write_all(out, reinterpret_cast<const char*>(&size), sizeof size) ||
        !write_all(out, said.data(), said.size()))
      break;
  }
  _exit(EXIT_SUCCESS);
}

class Child
{
public:
  explicit Child(const std::function<std::string()>& work)
  {
    std::array<int, 2> requests, answers;
    if (pipe(requests.data()) != 0 || pipe(answers.data()) != 0) throw std::logic_error("No pipe");
    id_ = fork();
    if (id_ < 0) throw std::logic_error("No child process");
    if (id_ == 0) {
      close(requests[1]), close(answers[0]);
      be_the_child(work, requests[0], answers[1]);
    }
    close(requests[0]), close(answers[1]);
    to_ = requests[1], from_ = answers[0];
  }
  ~Child()
  {
    close(to_), close(from_);
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Nothing when the child has crashed.
  std::optional<std::string> ask()
  {
    ++asked_;
    std::uint64_t size = 0;
    if (!write_all(to_, "g", 1) || !read_all(from_, reinterpret_cast<char*>(&size), sizeof size))
      return {};
    std::string said(size, ' ');
    if (!read_all(from_, said.data(), size)) return {};
    return said;
  }
  bool tired() const { return asked_ >= files_of_a_child; }

private:
  pid_t id_ = -1;
  int to_ = -1, from_ = -1, asked_ = 0;
};
} // namespace

// `work` must be the same each time: the child keeps the first one. The fuzzer reads one path.
std::string in_child_process(const std::function<std::string()>& work, const std::string& crash)
{
  static std::optional<Child> child;
  static const bool ready = [] { return std::signal(SIGPIPE, SIG_IGN) != SIG_ERR; }();
  if (!ready) throw std::logic_error("No signals");
  if (!child) child.emplace(work);
  const std::optional<std::string> said = child->ask();
  if (!said || child->tired()) child.reset();
  if (!said || said->empty()) throw std::runtime_error(crash);
  if (said->front() == threw) throw std::runtime_error(said->substr(1));
  return said->substr(1);
}
} // namespace interlock::fem
