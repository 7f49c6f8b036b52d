// The program `interlock`. Exit codes: 0 done, 2 bad input, 3 the simulation failed, 130
// interrupted.
#include "apps/build_info.h"
#include "apps/check_command.h"
#include "apps/clump_command.h"
#include "apps/drop/drop_command.h"
#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/nearest_name.h"
#include "apps/parameters_command.h"
#include "apps/ranks.h"
#include "apps/report_command.h"
#include "apps/run_command.h"
#include "apps/stones_command.h"
#include "apps/study/study_command.h"
#include "apps/template_command.h"
#include "dem/input_error.h"

#include <algorithm>
#include <csignal>
#include <functional>
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

// The end of a process that has failed. Of several ranks that end alike, one speaks; one that fails
// alone ends all.
int fail(const int code, const std::function<void()>& speak)
{
  const bool together = !apps::mpi_runs() || apps::all_have_failed();
  if (!together || !apps::mpi_runs() || apps::all_ranks().rank() == 0) speak();
  if (!together) apps::abort_ranks(code);
  return code;
}

// Only a run and a study have anything to share.
void refuse_several_ranks(const std::string& command)
{
  const bool asks_only = !command.empty() && command.front() == '-'; // --version, --help
  if (!apps::mpi_runs() || apps::all_ranks().size() == 1 || command == "run" ||
      command == "study" || asks_only)
    return;
  throw interlock::InputError(
      "mpirun started " + std::to_string(apps::all_ranks().size()) +
      " ranks, which can share \"interlock run\" and \"interlock study\" only; start this command "
      "without mpirun.");
}

// `interlock help` and `interlock help COMMAND`, as people type it. To be added last: the overview
// is made here, since CLI11 explains the command that has been typed once there is one.
void add_help_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand("help", "Explain the program or a command.");
  auto name = std::make_shared<std::string>();
  command->add_option("command", *name, "Command to explain.");
  const std::string overview = program.help();
  command->callback([&program, name, overview] {
    if (name->empty()) {
      std::cout << overview;
      return;
    }
    for (CLI::App* known : program.get_subcommands(nullptr))
      if (known->get_name() == *name) {
        std::cout << known->help(program.get_name());
        return;
      }
    throw interlock::InputError("There is no command \"" + *name + "\" (interlock --help).");
  });
}

void add_commands(CLI::App& program)
{
  program.require_subcommand(0, 1); // none: the overview
  program.set_version_flag("--version", std::string("interlock " INTERLOCK_VERSION " (commit ") +
                                            apps::build_commit + ", " + apps::build_commit_date +
                                            ", " + apps::build_compiler + ")");
  program.footer("Exit codes: 0 done, 2 bad input, 3 the simulation failed, 130 interrupted.\n"
                 "interlock COMMAND --help explains a command.");
  apps::add_run_command(program);
  apps::add_check_command(program);
  apps::add_study_command(program);
  apps::add_clump_command(program);
  apps::add_stones_command(program);
  apps::add_template_command(program);
  apps::add_parameters_command(program);
  apps::add_report_command(program);
  apps::add_drop_command(program);
  add_help_command(program);
}

// CLI11 takes an unknown word for a missing command; the word itself tells more.
void check_command(const CLI::App& program, const int argc, char** argv)
{
  const std::string word = argc > 1 ? argv[1] : "-";
  if (word.empty() || word.front() == '-') return;
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
  try {
    add_commands(program);
    if (apps::started_by_launcher()) apps::start_mpi();
    refuse_several_ranks(argc > 1 ? argv[1] : "");
    check_command(program, argc, argv);
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) std::cout << program.help();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) { // help, version
      const bool speaks = !apps::mpi_runs() || apps::all_ranks().rank() == 0;
      return speaks ? program.exit(error) : 0;
    }
    // A misspelt option may be why another one is missing.
    const std::string unknown = unknown_options(program);
    return fail(bad_input, [&] {
      print_errors(unknown.empty() ? std::string(error.what()) + " (interlock --help)" : unknown);
    });
  } catch (const interlock::InputError& error) {
    return fail(bad_input, [&] { print_errors(error.what()); });
  } catch (const apps::Interrupted& error) {
    return fail(interrupted, [&] { std::cerr << "interlock: " << error.what() << '\n'; });
  } catch (const std::exception& error) {
    const std::string sentence = error.what();
    const bool whole = !sentence.empty() && sentence.back() == '.';
    const char* start =
        program.got_subcommand("run") ? "interlock: the run failed: " : "interlock: error: ";
    return fail(failed, [&] { std::cerr << start << sentence << (whole ? "\n" : ".\n"); });
  }
  return 0;
}
} // namespace

int main(int argc, char** argv)
{
  // A limit on the size of files is a full disk to us: an error with a sentence, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  const int code = run_program(argc, argv);
  apps::stop_mpi();
  return code;
}
