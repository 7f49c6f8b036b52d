#include "coupling/files/compressed_file.h"

#include "coupling/files/atomic_file.h"
#include "dem/input_error.h"

#include <zlib.h>

#include <array>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
// As a gzip file holds it.
std::string compressed(const std::string& text)
{
  constexpr int gzip_window = 15 + 16, memory_level = 8; // zlib.h, deflateInit2
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot be used");
  std::string result(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error("zlib could not compress a text");
  return result;
}
} // namespace

std::string read_maybe_compressed(const std::filesystem::path& file)
{
  const auto refuse = [&](const std::string& what) {
    throw InputError("The file \"" + file.string() + "\" " + what + ".");
  };
  const gzFile stream =
      std::filesystem::is_regular_file(file) ? gzopen(file.c_str(), "rb") : nullptr;
  if (!stream) refuse("cannot be read");
  std::string text;
  std::array<char, 1 << 16> buffer{};
  int n = 0;
  while ((n = gzread(stream, buffer.data(), buffer.size())) > 0) text.append(buffer.data(), n);
  // A file that is cut off ends like a complete one, and says so here only.
  int status = Z_OK;
  gzerror(stream, &status);
  const int closed = gzclose_r(stream);
  if (n < 0 || status != Z_OK || closed != Z_OK)
    refuse("is damaged or cut off: gzip cannot unpack it");
  return text;
}

void write_maybe_compressed(const std::filesystem::path& file, const std::string& text)
{
  write_atomically(file, file.extension() == ".gz" ? compressed(text) : text);
}
} // namespace interlock::coupling
