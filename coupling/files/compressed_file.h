// Text files, compressed with gzip or not.
#pragma once

#include <filesystem>
#include <string>

namespace interlock::coupling
{
// The text of a file; one that starts with gzip's mark is unpacked, whatever its name. Throws
// InputError, one full sentence, when it cannot be read, or is cut off or damaged.
std::string read_maybe_compressed(const std::filesystem::path& file);

// Compresses when the name ends with .gz. Written under a temporary name first; throws
// std::runtime_error when it cannot be written.
void write_maybe_compressed(const std::filesystem::path& file, const std::string& text);
} // namespace interlock::coupling
