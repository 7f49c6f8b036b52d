// `interlock report FOLDER`: the figures of a finished or running simulation.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>

namespace interlock::apps
{
void add_report_command(CLI::App& program);

// Draws FOLDER/figures/*.png with the script of its experiment, apps/figures.py or
// apps/heap_figures.py (Python 3 with Matplotlib). The exit status of
// the script: 0 done, 2 nothing to draw in the folder, anything else: it broke or Python is
// missing.
int draw_figures(const std::filesystem::path& folder);
} // namespace interlock::apps
