// `interlock template EXPERIMENT`: a documented parameter file to start from.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
// Adds the subcommand, which prints the template of an experiment (experiments.h) to standard
// output.
void add_template_command(CLI::App& program);
} // namespace interlock::apps
