#include "apps/template_command.h"

#include "apps/case_templates.h"
#include "apps/experiments.h"

#include <iostream>

namespace interlock::apps
{
namespace
{
constexpr const char* study = "study";
}

void add_template_command(CLI::App& program)
{
  CLI::App* command =
      program.add_subcommand("template", "Print a documented parameter file to start from.");
  auto experiment = std::make_shared<std::string>();
  std::vector<std::string> names = experiment_names();
  names.emplace_back(study);
  command
      ->add_option("experiment", *experiment,
                   "What to simulate: " + CLI::detail::join(names, ", ") +
                       " (the file of \"interlock "
                       "study\").")
      ->required()
      ->check(CLI::IsMember(names, present_name));
  command->footer("Examples: interlock template pull-out > my.prm\n"
                  "          interlock template study > my_study.prm");
  command->callback([experiment] {
    std::cout << (*experiment == study ? study_template()
                                       : find_experiment(*experiment)->template_text);
  });
}
} // namespace interlock::apps
