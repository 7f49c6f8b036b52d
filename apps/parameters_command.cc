#include "apps/parameters_command.h"

#include "apps/parameter_page.h"
#include "dem/input_error.h"

#include <iostream>

namespace interlock::apps
{
void add_parameters_command(CLI::App& program)
{
  CLI::App* command = program.add_subcommand(
      "parameters", "Explain the entries of parameter files: unit, range, default.");
  auto word = std::make_shared<std::string>();
  auto page = std::make_shared<bool>(false);
  command->add_option("word", *word, "Only entries with this word in their name or meaning.");
  command->add_flag("--page", *page, "All of them as docs/parameters.md has them.");
  command->footer("Examples: interlock parameters friction\n"
                  "          interlock parameters Pull/");
  command->callback([word, page] {
    if (*page) {
      std::cout << parameter_page();
      return;
    }
    const std::vector<ParameterLine> lines = lines_about(*word);
    if (lines.empty()) throw InputError("No entry has \"" + *word + "\" in its name or meaning.");
    std::cout << parameter_text(lines);
  });
}
} // namespace interlock::apps
