// The end of a study: its files, its figures, and whether all went well.
#pragma once

#include "apps/study/run_table.h"

#include <functional>
#include <string>

namespace interlock::apps
{
// runs.csv, means.csv, differences.csv, variance.csv, curves.h5 and times.csv, of what is on the
// disk.
void write_results(const RunTable& table);

// These, the figures, and a sentence for each run that is not done. Throws std::runtime_error when
// there is one.
void conclude(const Plan& plan, const std::function<void(const std::string&)>& say);
} // namespace interlock::apps
