#include "apps/program_file.h"

namespace interlock::apps
{
namespace fs = std::filesystem;

namespace
{
fs::path named;
}

fs::path program_file()
{
  if (!named.empty()) return named;
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

void name_program_file(const fs::path& file)
{
  named = file;
}
} // namespace interlock::apps
