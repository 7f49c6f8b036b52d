#include "apps/template_command.h"

#include <iostream>

namespace interlock::apps
{
void add_template_command(CLI::App& program)
{
  CLI::App* command =
      program.add_subcommand("template", "Print a documented parameter file to start from.");
  auto experiment = std::make_shared<std::string>();
  command->add_option("experiment", *experiment, "What to simulate: pull-out.")
      ->required()
      ->check(CLI::IsMember({"pull-out"}));
  command->footer("Example: interlock template pull-out > my.prm");
  command->callback([experiment] { std::cout << pull_out_template(); });
}
} // namespace interlock::apps
