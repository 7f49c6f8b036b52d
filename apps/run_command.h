// `interlock run FILE`: one simulation from a parameter file into an output folder.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
// Adds the subcommand. Running it throws InputError (bad input, nothing has been written),
// Interrupted, or whatever the simulation throws.
void add_run_command(CLI::App& program);
} // namespace interlock::apps
