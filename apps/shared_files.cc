#include "apps/shared_files.h"

#include <cstdlib>

#include <dlfcn.h>
#include <link.h>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

// The file that this code was loaded from. The loader gives a program itself no name.
fs::path own_file()
{
  Dl_info info;
  link_map* map = nullptr;
  const int found = dladdr1(reinterpret_cast<const void*>(&own_file), &info,
                            reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP);
  std::error_code error;
  if (found != 0 && map && map->l_name[0] != '\0') return fs::canonical(map->l_name, error);
  return fs::read_symlink("/proc/self/exe", error);
}
} // namespace

fs::path shared_folder()
{
  if (const char* named = std::getenv("INTERLOCK_SHARE")) return named;
  std::error_code error;
  for (fs::path folder = own_file().parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    if (fs::is_directory(folder / "share/interlock", error)) return folder / "share/interlock";
  return {};
}
} // namespace interlock::apps
