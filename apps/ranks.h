// The processes of one run under mpirun: who speaks, who writes, and how all end together.
#pragma once

#include "dem/parallel/ranks.h"

#include <functional>

namespace interlock::apps
{
// All processes, after start_mpi().
const dem::Ranks& all_ranks();

// Calls f on the first rank; the others wait without spinning. What it throws is thrown on all of
// them. Collective.
void on_first_rank(const std::function<void()>& f);

// For a rank that has failed and is about to say so. True when all ranks have failed: then the
// first one speaks for them, and they end as if they were alone. Waits for the others for a little
// while, since they may be about to fail, too. False: this rank has failed alone; the others wait
// for it somewhere, and end with abort_ranks() only.
bool all_have_failed();
// Ends all processes with this exit code.
[[noreturn]] void abort_ranks(int code);
} // namespace interlock::apps
