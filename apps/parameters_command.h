// `interlock parameters [WORD]`: what entries parameter files may have.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
void add_parameters_command(CLI::App& program);
} // namespace interlock::apps
