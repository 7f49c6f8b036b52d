// Files of a run that a reader finds complete or not at all (dem/atomic_files.h).
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace interlock::coupling
{
// A file of a run cannot be written: one sentence that names it and the reason.
class WriteError : public std::runtime_error
{
public:
  // From errno as it is now: "the file results/x cannot be written: No space left on device".
  explicit WriteError(const std::filesystem::path& file);
};

// Writes `text` under the temporary name `file`.part, then renames it. Throws WriteError when the
// disk is full or the folder is gone; the old file is untouched then, and no temporary one is left.
void write_atomically(const std::filesystem::path& file, const std::string& text);

// The same, and sure to be on the disk before it gets its name, so that a power failure does not
// take it either. A file that had the name is renamed to `keep_as` before, unless that is empty.
void write_durably(const std::filesystem::path& file, const std::string& bytes,
                   const std::filesystem::path& keep_as = {});
} // namespace interlock::coupling
