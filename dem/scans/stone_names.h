// Which files are stones, by their names.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <vector>

namespace interlock::dem
{
constexpr std::initializer_list<const char*> mesh_endings = {".stl", ".ply", ".obj"};
constexpr std::initializer_list<const char*> stone_endings = {".stl", ".ply", ".obj", ".xyz"};

// Whether the name ends with one of these, in any case of letters.
bool has_ending(const std::filesystem::path& path, std::initializer_list<const char*> endings);

// Whether an entry of a folder of stones is one of them: has one of the endings, is no folder, and
// its name does not start with a dot. Names with a dot are hidden files: a Mac writes "._stone.stl"
// with notes of its own beside every stone on a disk that is not its own. A link that leads nowhere
// is a stone, so that it gets missed.
bool is_stone_file(const std::filesystem::directory_entry& entry,
                   std::initializer_list<const char*> endings);

// The clumps (*.clump.json) in a folder, by name; hidden files do not count. Empty when there are
// none or the folder cannot be read.
std::vector<std::filesystem::path> clump_files(const std::filesystem::path& folder);
} // namespace interlock::dem
