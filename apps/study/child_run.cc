#include "apps/study/child_run.h"

#include "apps/output_folder.h"
#include "apps/run_folder.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int not_started = 127;

// Without what tells an MPI process that it is a rank of the job of this one.
Words environment_of_lone_process()
{
  Words kept;
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    bool of_job = false;
    for (const char* start :
         {"PMIX_", "PMI_", "OMPI_COMM_", "OMPI_MCA_orte_", "OMPI_MCA_ess", "OMPI_MCA_pmix",
          "OMPI_UNIVERSE_", "OMPI_APP_", "OMPI_NUM_APP", "OMPI_FIRST_RANKS", "OMPI_FILE_LOCATION",
          "OMPI_COMMAND", "OMPI_ARGV"})
      of_job = of_job || boost::starts_with(text, start);
    if (!of_job) kept.push_back(text);
  }
  return kept;
}

std::vector<char*> pointers(Words& words)
{
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

Words command_for(const TaskFolder& task, int ranks)
{
  const fs::path program = fs::read_symlink("/proc/self/exe");
  Words words;
  if (ranks > 1)
    words = {"mpirun", "-n", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
  words.insert(words.end(), {program.string(), "run", task.case_file().string(), "--output",
                             task.folder().string()});
  words.emplace_back(task.progress() == TaskProgress::stopped ? "--resume" : "--force");
  return words;
}

// A run whose study was killed lets go of its folder as soon as it has kept its state.
void wait_for_folder(const fs::path& folder)
{
  using namespace std::chrono;
  constexpr seconds patience(30);
  const auto end = steady_clock::now() + patience;
  for (;;) {
    try {
      const RunFolder probe(folder, FolderUse::resume);
      return;
    } catch (const InputError&) {
      if (steady_clock::now() > end) return; // the run itself says why
    }
    std::this_thread::sleep_for(milliseconds(50));
  }
}

// In the child: never returns.
[[noreturn]] void become(char** words, char** variables, const char* messages, pid_t parent)
{
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(not_started);
  const int nothing = open("/dev/null", O_RDWR);
  const int errors = open(messages, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  if (errors >= 0) dup2(errors, STDERR_FILENO);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  environ = variables;
  execvp(words[0], words);
  _exit(not_started);
}
} // namespace

ChildRun::~ChildRun()
{
  if (!runs()) return;
  stop();
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void ChildRun::start(const TaskFolder& task, int ranks)
{
  wait_for_folder(task.folder());
  messages_ = task.messages();
  create_output_folder(messages_.parent_path());
  Words words = command_for(task, ranks), variables = environment_of_lone_process();
  const std::vector<char*> arguments = pointers(words), environment = pointers(variables);
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0)
    become(const_cast<char**>(arguments.data()), const_cast<char**>(environment.data()),
           messages_.c_str(), parent);
  if (child_ < 0)
    throw std::runtime_error(std::string("a run cannot be started: ") + std::strerror(errno) + ".");
  setpgid(child_, child_); // whoever is first
}

void ChildRun::stop()
{
  if (runs()) kill(child_, SIGTERM);
}

std::optional<int> ChildRun::ending()
{
  int status = 0;
  if (!runs() || waitpid(child_, &status, WNOHANG) != child_) return {};
  child_ = 0;
  std::ofstream messages(messages_, std::ios::app);
  if (WIFEXITED(status)) {
    const int code = WEXITSTATUS(status);
    const bool spoke =
        code == 0 || code == 2 || code == 3 || code == 130; // those of `interlock run`
    if (!spoke) messages << "interlock: it ended with code " << code << ".\n";
    return code;
  }
  messages << "interlock: it was ended by signal " << WTERMSIG(status) << ".\n";
  return -WTERMSIG(status);
}
} // namespace interlock::apps
