// `interlock check CASE`: what a run would be and take, without the run.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
void add_check_command(CLI::App& program);
} // namespace interlock::apps
