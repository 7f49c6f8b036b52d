// The program `interlock`. Exit codes: 0 done, 2 bad input, 3 the simulation failed, 130
// interrupted.
#include "apps/clump_command.h"
#include "apps/interruption.h"
#include "apps/nearest_name.h"
#include "apps/report_command.h"
#include "apps/run_command.h"
#include "apps/stones_command.h"
#include "apps/template_command.h"
#include "dem/input_error.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <sstream>

namespace
{
namespace apps = interlock::apps;

constexpr int bad_input = 2;
constexpr int failed = 3;
constexpr int interrupted = 130;

// One line of the text is one sentence.
void print_errors(const std::string& text)
{
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    std::cerr << "interlock: error: " << line << '\n';
}

void add_commands(CLI::App& program)
{
  program.require_subcommand(1);
  program.set_version_flag("--version", "interlock " INTERLOCK_VERSION);
  program.footer("Exit codes: 0 done, 2 bad input, 3 the simulation failed, 130 interrupted.\n"
                 "interlock COMMAND --help explains a command.");
  apps::add_run_command(program);
  apps::add_clump_command(program);
  apps::add_stones_command(program);
  apps::add_template_command(program);
  apps::add_report_command(program);
}

// CLI11 takes an unknown word for a missing command; the word itself tells more.
void check_command(const CLI::App& program, const int argc, char** argv)
{
  const std::string word = argc > 1 ? argv[1] : "-";
  if (word.front() == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* command : program.get_subcommands(nullptr))
    known.push_back(command->get_name());
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  const std::string nearest = apps::nearest_name(word, known);
  throw interlock::InputError("There is no command \"" + word + "\"; " +
                              (nearest.empty()
                                   ? "the commands are " + CLI::detail::join(known, ", ")
                                   : "the nearest known one is \"" + nearest + "\"") +
                              ".");
}

// One sentence an option that its command does not know, with the name that was probably meant.
std::string unknown_options(const CLI::App& program)
{
  std::string text;
  for (const CLI::App* command : program.get_subcommands()) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (const std::string& word : command->remaining()) {
      const std::string name = word.substr(0, word.find('='));
      if (name.size() < 2 || name.front() != '-') continue;
      const std::string nearest = apps::nearest_name(name, known);
      text += "There is no option \"" + name + "\" of interlock " + command->get_name() + "; " +
              (nearest.empty() ? "\"interlock " + command->get_name() + " --help\" lists them"
                               : "the nearest known one is \"" + nearest + "\"") +
              ".\n";
    }
  }
  return text;
}

int run_program(const int argc, char** argv)
{
  CLI::App program(
      "Pull-out tests of geogrids in ballast: clump DEM coupled with beam finite elements.",
      "interlock");
  add_commands(program);
  try {
    check_command(program, argc, argv);
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error); // help, version
    // A misspelt option may be why another one is missing.
    const std::string unknown = unknown_options(program);
    print_errors(unknown.empty() ? std::string(error.what()) + " (interlock --help)" : unknown);
    return bad_input;
  } catch (const interlock::InputError& error) {
    print_errors(error.what());
    return bad_input;
  } catch (const apps::Interrupted& error) {
    std::cerr << "interlock: " << error.what() << '\n';
    return interrupted;
  } catch (const std::exception& error) {
    const std::string sentence = error.what();
    const bool whole = !sentence.empty() && sentence.back() == '.';
    std::cerr << "interlock: the run failed: " << sentence << (whole ? "\n" : ".\n");
    return failed;
  }
  return 0;
}
} // namespace

int main(int argc, char** argv)
{
  // A limit on the size of files is a full disk to us: an error with a sentence, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  // MPI and PETSc get no arguments: PETSc would answer --help and --version itself.
  int no_arguments = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(no_arguments, argv, 1);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1) return run_program(argc, argv);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    print_errors("This version runs on one MPI rank; start it without mpirun or with \"-n 1\".");
  return bad_input;
}
