// Words of a shell's command line.
#pragma once

#include <string>

namespace interlock::apps
{
// As a shell takes it for one word, in quotes where it must be.
std::string shell_word(const std::string& word);
} // namespace interlock::apps
