// The known name that somebody probably meant.
#pragma once

#include <string>
#include <vector>

namespace interlock::apps
{
// The name of `known` with the smallest edit distance to `name`, upper and lower case alike; empty
// when none is near (more than a third of the letters differ, but two letters always may).
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);
} // namespace interlock::apps
