// Files of a run that a reader finds complete or not at all (dem/atomic_files.h).
#pragma once

#include <filesystem>
#include <string>

namespace interlock::coupling
{
// Writes `text` under the temporary name `file`.part, then renames it. Throws std::runtime_error
// when the disk is full or the folder is gone; the old file is untouched then, and no temporary one
// is left.
void write_atomically(const std::filesystem::path& file, const std::string& text);
} // namespace interlock::coupling
