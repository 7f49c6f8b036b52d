// Small files that a reader finds complete or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace interlock::coupling
{
// Writes `text` under the temporary name `file`.part, then renames it. Throws std::runtime_error
// when the disk is full or the folder is gone; the old file is untouched then.
void write_atomically(const std::filesystem::path& file, const std::string& text);
} // namespace interlock::coupling
