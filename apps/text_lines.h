// The lines of a text file as editors of all systems write them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
// Lines end with LF, CR LF or CR. A byte order mark (UTF-8) at the head is left out, a no-break or
// another wide space of Unicode becomes a blank, a character without width vanishes: web pages and
// word processors put them where nobody sees them. Throws InputError when the file cannot be read
// or is written in UTF-16.
std::vector<std::string> read_text_lines(const std::filesystem::path& file);
} // namespace interlock::apps
