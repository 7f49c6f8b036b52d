// `interlock study`: many runs of one case, several at a time, and what they say together.
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
void add_study_command(CLI::App& program);
} // namespace interlock::apps
