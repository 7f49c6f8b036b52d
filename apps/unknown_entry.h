// Entries of parameter files that a table has, or has not.
#pragma once

#include "apps/parameter_scanner.h"
#include "coupling/parameters/parameter_table.h"

#include <string>

namespace interlock::apps
{
// Null when there is none of this key ("Section/Name").
const coupling::ParameterEntry* find_entry(const coupling::ParameterTable& table,
                                           const std::string& key);

// A full sentence without the place for an assignment whose entry the table lacks: the nearest
// known one, or those of its section.
std::string explain_unknown(const coupling::ParameterTable& table, const Assignment& assignment);
} // namespace interlock::apps
