#include "apps/template_command.h"

#include "apps/experiments.h"

#include <iostream>

namespace interlock::apps
{
void add_template_command(CLI::App& program)
{
  CLI::App* command =
      program.add_subcommand("template", "Print a documented parameter file to start from.");
  auto experiment = std::make_shared<std::string>();
  const std::vector<std::string> names = experiment_names();
  command
      ->add_option("experiment", *experiment,
                   "What to simulate: " + CLI::detail::join(names, ", ") + ".")
      ->required()
      ->check(CLI::IsMember(names, present_name));
  command->footer("Example: interlock template pull-out > my.prm");
  command->callback([experiment] { std::cout << find_experiment(*experiment)->template_text; });
}
} // namespace interlock::apps
