// The file of the program: what a study starts again, and beside which scripts are looked for.
#pragma once

#include <filesystem>

namespace interlock::apps
{
// That of this process, or the one that was named; empty when the system does not say.
std::filesystem::path program_file();

// For a process that is another program, such as Python: where `interlock` is, or would be.
void name_program_file(const std::filesystem::path& file);
} // namespace interlock::apps
