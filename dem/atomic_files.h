// Files that a reader finds complete or not at all, and files that belong together all or none.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace interlock::dem
{
struct FileText {
  std::filesystem::path path;
  std::string text;
};

// Writes every text under a temporary name, `path`.part, and renames them when all are there. A
// folder of a path that does not exist yet is built under its temporary name likewise, so that it
// appears whole. Returns the path that could not be written, if one could not: the temporary files
// are removed and the old files untouched then.
std::optional<std::filesystem::path> write_atomically(const std::vector<FileText>& files);

// The same of one file, whose folder must exist; false when it could not be written.
[[nodiscard]] bool write_atomically(const std::filesystem::path& path, const std::string& text);
} // namespace interlock::dem
