// Clumps that are no good stand-in for their stone, and which setting makes a better one.
#pragma once

#include "apps/clump_table.h"

namespace interlock::apps
{
// One sentence each: the spheres are in several groups that do not touch; their union has a volume
// that is off by more than largest_volume_error (unless a target for it was asked for and met).
// Empty for a good clump.
std::string clump_warnings(const ClumpResult& result);
constexpr double largest_volume_error = 0.1; // [-]
} // namespace interlock::apps
