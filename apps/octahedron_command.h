// Published tables of clumps beside ours.
#pragma once

#include <string>

namespace interlock::apps
{
// "octahedron": Tables 1 to 3 of Ferellec and McDowell (2010). Throws InputError for other names.
void print_published_table(const std::string& name);
} // namespace interlock::apps
