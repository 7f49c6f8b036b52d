// `interlock report FOLDER`: the figures and the page of a finished or running simulation.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>

namespace interlock::apps
{
// Refuses a folder whose used.prm and summary.json are those of two runs (case_hash.h).
void add_report_command(CLI::App& program);

// Draws FOLDER/figures/*.png with the script of its experiment (figure_script.h), writes
// FOLDER/report.html with report.py, and returns ScriptResult::status of the first one that failed;
// where that is not 0, says the reason on the standard error. What the scripts print is not shown
// if it is to be quiet.
int draw_figures(const std::filesystem::path& folder, bool quiet = false);
} // namespace interlock::apps
