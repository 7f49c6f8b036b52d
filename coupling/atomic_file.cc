#include "coupling/atomic_file.h"

#include <fstream>
#include <stdexcept>

namespace interlock::coupling
{
void write_atomically(const std::filesystem::path& file, const std::string& text)
{
  const std::filesystem::path part = file.string() + ".part";
  {
    std::ofstream stream(part, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) throw std::runtime_error("the file " + part.string() + " cannot be written");
  }
  std::filesystem::rename(part, file);
}
} // namespace interlock::coupling
