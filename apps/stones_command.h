// `interlock stones`: a batch of synthetic ballast stones as STL files.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
// Adds the subcommand; it runs while `app` parses, prints a table and throws InputError.
void add_stones_command(CLI::App& app);
} // namespace interlock::apps
