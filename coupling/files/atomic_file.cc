#include "coupling/files/atomic_file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace interlock::coupling
{
namespace
{
namespace fs = std::filesystem;

bool write_all(int file, const std::string& bytes)
{
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(file, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

[[noreturn]] void fail(const fs::path& file, const fs::path& part)
{
  const WriteError error(file);
  ::unlink(part.c_str());
  throw error;
}

void sync_folder(const fs::path& file)
{
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor < 0) return;
  ::fsync(descriptor); // some file systems cannot, and do not need to
  ::close(descriptor);
}

// Leaves `file`.part complete.
fs::path write_part(const fs::path& file, const std::string& bytes, bool durable)
{
  const fs::path part = file.string() + ".part";
  const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(file, part);
  bool good = write_all(descriptor, bytes);
  if (good && durable) good = ::fsync(descriptor) == 0 || errno == EINVAL;
  const int error = errno;
  const bool closed = ::close(descriptor) == 0;
  if (!good) errno = error;
  if (!good || !closed) fail(file, part);
  return part;
}
} // namespace

WriteError::WriteError(const fs::path& file)
    : std::runtime_error("the file " + file.string() +
                         " cannot be written: " + std::strerror(errno))
{
}

void write_atomically(const fs::path& file, const std::string& text)
{
  const fs::path part = write_part(file, text, false);
  if (::rename(part.c_str(), file.c_str()) != 0) fail(file, part);
}

void write_durably(const fs::path& file, const std::string& bytes, const fs::path& keep_as)
{
  const fs::path part = write_part(file, bytes, true);
  if (!keep_as.empty() && ::rename(file.c_str(), keep_as.c_str()) != 0 && errno != ENOENT)
    fail(file, part);
  if (::rename(part.c_str(), file.c_str()) != 0) fail(file, part);
  sync_folder(file);
}
} // namespace interlock::coupling
