// `interlock clump`: from a scanned stone to a clump file, with a report on how good the clump is.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
// Adds the subcommand; it runs while `app` parses, prints a report and throws InputError.
void add_clump_command(CLI::App& app);
} // namespace interlock::apps
