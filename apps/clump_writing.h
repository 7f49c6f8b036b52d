// The files of a clump and of the report, and what there is to say about those for other codes.
#pragma once

#include "apps/clump_files.h"
#include "apps/clump_orders.h"
#include "apps/clump_table.h"

namespace interlock::apps
{
// A stone from which no clump could be made, and why.
struct Refusal {
  std::string stone, sentence;
};

// The clump file, and those for other codes. Throws InputError when another code cannot take it.
std::vector<dem::FileText> clump_texts(const StoneFiles& files, const ClumpResult& result);

// Writes them all or none, and makes the folder of the first. Throws InputError when one cannot be
// written.
void write_files(const std::vector<dem::FileText>& texts);

// JSON of all clumps, of which there must be one at least, and of both orders where they were
// compared. Throws likewise.
void write_report(const std::string& path, const std::vector<ClumpResult>& results,
                  const std::vector<Refusal>& refusals, const std::vector<OrderRow>& orders);

// A line for each other code.
std::string export_lines(const StoneFiles& files, const ClumpResult& result);

// In short, for many stones: only what is not named as the stone is, or is off.
std::string export_remarks(const StoneFiles& files, const ClumpResult& result);
} // namespace interlock::apps
