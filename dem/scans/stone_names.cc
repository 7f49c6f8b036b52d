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
} // namespace interlock::dem
