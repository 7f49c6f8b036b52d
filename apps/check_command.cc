#include "apps/check_command.h"

#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/parameter_file.h"
#include "apps/progress.h"
#include "apps/ranks.h"
#include "apps/run_cost.h"
#include "coupling/run/machine_speed.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>

namespace interlock::apps
{
namespace
{
struct CheckArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool unusual = false;
};

void print(const coupling::Forecast& forecast)
{
  if (!forecast.stones.empty()) std::cout << forecast.stones << ".\n";
  for (const std::string& warning : forecast.warnings) std::cout << "warning: " << warning << '\n';
  if (forecast.clumps > 0)
    std::cout << fmt::format("About {} stones of {} spheres together, time step {:.3g} us.\n",
                             forecast.clumps, forecast.spheres, 1e6 * forecast.time_step);
  if (forecast.stages.empty()) return;
  std::cout << fmt::format("\n{:<18}{:>14}{:>12}{:>18}\n", "stage", "simulated [s]", "steps",
                           "processor time");
  std::int64_t steps = 0;
  for (const coupling::StageForecast& stage : forecast.stages) {
    steps += forecast.steps(stage);
    std::cout << fmt::format("{:<18}{:>14.3g}{:>12}{:>18}\n", stage.name, stage.simulated_time,
                             forecast.steps(stage), duration_text(forecast.time(stage)));
  }
  std::cout << fmt::format("{:<18}{:>14}{:>12}{:>18}\n\n", "in all", "", steps,
                           duration_text(forecast.time()))
            << cost_text(forecast, all_ranks().size()) << '\n';
}

void check(CheckArguments arguments)
{
  if (arguments.unusual) arguments.overrides.push_back("Unusual values=true");
  const RunInput input = read_parameter_file(arguments.file, arguments.overrides);
  start_mpi();
  catch_interruption();
  coupling::RunRequest request;
  request.entries = input.kept;
  request.monitor.progress = [](const coupling::Progress&) { throw_if_interrupted(); };
  request.monitor.message = [](const std::string& sentence) { std::cout << sentence << '\n'; };
  coupling::Forecast forecast = input.experiment->forecast(input.parameters, request);
  coupling::measure_machine(forecast);
  print(forecast);
  std::cout << "The case can be run: interlock run " << arguments.file << '\n';
}
} // namespace

void add_check_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "check", "Check a parameter file and say what its run would take, without the run.");
  auto arguments = std::make_shared<CheckArguments>();
  command->add_option("file", arguments->file, "Parameter file (.prm).")->required();
  command
      ->add_option("--set", arguments->overrides,
                   "Override an entry of the file, as in \"interlock run\".")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  command->add_flag("--unusual", arguments->unusual,
                    "Take values that are far from those of ballast and geogrids as they are.");
  command->footer("Example: interlock check cases/pullout/quick.prm");
  command->callback([arguments] { check(*arguments); });
}
} // namespace interlock::apps
