// `interlock template pull-out`: a documented parameter file to start from.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
// Adds the subcommand, which prints the pull-out case of Ferellec and McDowell (2010) to standard
// output.
void add_template_command(CLI::App& program);

// The text that it prints: cases/pullout/pullout.prm, as it was when the program was built.
const char* pull_out_template();
} // namespace interlock::apps
