// `interlock drop FOLDER`: the contact forces before, during and after the largest drop of a
// pull-out force, as figure 13 of Ferellec and McDowell (2010).
#pragma once

#include <CLI/CLI.hpp>

namespace interlock::apps
{
// Refuses folders that are no finished pull-out of one run (case_hash.h), and pulls without a drop
// (force_drop.h). Writes FOLDER/drop, the second pull with its frames (second_pull.h), and
// FOLDER/figures/force_drop.png.
void add_drop_command(CLI::App& program);
} // namespace interlock::apps
