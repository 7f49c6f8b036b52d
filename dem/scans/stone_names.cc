#include "dem/scans/stone_names.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace interlock::dem
{
bool has_ending(const std::filesystem::path& path, std::initializer_list<const char*> endings)
{
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool is_stone_file(const std::filesystem::directory_entry& entry,
                   std::initializer_list<const char*> endings)
{
  std::error_code error;
  return entry.path().filename().string()[0] != '.' && has_ending(entry.path(), endings) &&
         !entry.is_directory(error);
}

std::vector<std::filesystem::path> clump_files(const std::filesystem::path& folder)
{
  const std::string ending = ".clump.json";
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name[0] != '.' && name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}
} // namespace interlock::dem
