#include "coupling/output/atomic_file.h"

#include "dem/atomic_files.h"

#include <stdexcept>

namespace interlock::coupling
{
void write_atomically(const std::filesystem::path& file, const std::string& text)
{
  if (!dem::write_atomically(file, text))
    throw std::runtime_error("the file " + file.string() + " cannot be written");
}
} // namespace interlock::coupling
