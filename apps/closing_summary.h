// What a run that has ended says on a terminal: the numbers that matter most, and where the others
// are.
#pragma once

#include "coupling/output/summary.h"

#include <filesystem>
#include <string>

namespace interlock::apps
{
// At most 18 lines, so that those of the figures fit on the screen, too: what was done; the most
// important results of the experiment first, then others as far as there is room, with four digits
// and their units (result_text.h); the error of the energy ledger; the number of warnings; where
// all numbers are with all their digits.
std::string closing_summary(const coupling::Summary& summary, const std::filesystem::path& folder);

// One line on what to do next: the page to open where there is one, else the command that tries to
// write it, or of an experiment without a page its numbers.
std::string next_step(const std::filesystem::path& folder, bool draws_figures);
} // namespace interlock::apps
