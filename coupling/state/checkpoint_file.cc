#include "coupling/state/checkpoint_file.h"

#include "coupling/files/atomic_file.h"
#include "coupling/files/hdf5_memory.h"
#include "dem/input_error.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
namespace fs = std::filesystem;

// HDF5 looks for its own beginning at 0, 512, 1024, ..., so a block of 512 bytes may stand in
// front.
constexpr std::size_t block_size = 512;
const std::string magic = "Interlock state\n";

std::string checksum(const char* bytes, std::size_t size)
{
  const XXH128_hash_t hash = XXH3_128bits(bytes, size);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

// Text, filled up with blanks; its last line is the checksum of the lines before.
std::string block_for(const std::string& data, const std::string& version)
{
  std::string text =
      magic + fmt::format("format {}\nprogram {}\nbytes {}\nxxh3-128 {}\n", state_format, version,
                          data.size(), checksum(data.data(), data.size()));
  constexpr std::size_t closing = 32 + 1; // checksum and line feed
  text.resize(block_size - closing, ' ');
  return text + checksum(text.data(), text.size()) + '\n';
}

std::string image_of(const StateTree& state)
{
  Hdf5Memory file;
  for (const auto& [path, array] : state)
    std::visit([&, &name = path, &columns = array.columns, &unit = array.unit](
                   const auto& values) { file.write(name, values, columns, unit); },
               array.values);
  return file.bytes();
}

template <class T>
void read_array(const Hdf5Memory& file, const Hdf5Memory::DataSet& set, StateTree& state)
{
  std::vector<T> values;
  file.read(set.path, values);
  state[set.path] = {std::move(values), set.columns, set.unit};
}

StateTree tree_of(const std::string& image)
{
  const Hdf5Memory file(image);
  StateTree state;
  for (const Hdf5Memory::DataSet& set : file.data_sets()) {
    if (set.type == Hdf5Memory::Type::number) read_array<double>(file, set, state);
    if (set.type == Hdf5Memory::Type::integer) read_array<std::int64_t>(file, set, state);
    if (set.type == Hdf5Memory::Type::text) read_array<std::string>(file, set, state);
  }
  return state;
}

// What is wrong with the bytes of a file, without its name; empty when nothing is.
std::string fault_of(const std::string& bytes)
{
  if (bytes.empty()) return "is empty";
  if (bytes.compare(0, magic.size(), magic) != 0)
    return "is no state that this program has written";
  if (bytes.size() < block_size) return "is cut off";
  std::istringstream block(bytes.substr(magic.size(), block_size - magic.size()));
  std::string word, version, sum;
  int format = 0;
  std::size_t size = 0;
  block >> word >> format;
  const std::size_t text = block_size - 33;
  const bool whole = bytes.substr(text, 32) == checksum(bytes.data(), text) && bytes[511] == '\n';
  if (!whole) return "is damaged: the block at its head has changed";
  if (format != state_format)
    return fmt::format("has the format {}, but this version of the program reads format {}", format,
                       state_format);
  std::getline(block >> std::ws, version); // "program 0.1.0"
  block >> word >> size >> word >> sum;
  if (bytes.size() < block_size + size)
    return fmt::format("is cut off: {} of {} bytes are there", bytes.size(), block_size + size);
  if (bytes.size() > block_size + size) return "is damaged: it is longer than it was written";
  if (checksum(bytes.data() + block_size, size) != sum)
    return "is damaged: its checksum differs from the one it was written with";
  return {};
}

std::string bytes_of(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError("The file \"" + file.string() + "\" cannot be opened.");
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

bool is_good(const fs::path& file)
{
  std::error_code error;
  return fs::is_regular_file(file, error) && fault_of(bytes_of(file)).empty();
}

void write(const fs::path& file, const StateTree& state, const std::string& version,
           const fs::path& keep_as)
{
  const std::string image = image_of(state);
  write_durably(file, block_for(image, version) + image, keep_as);
}
} // namespace

fs::path previous_of(const fs::path& file)
{
  return file.parent_path() / (file.stem().string() + ".previous" + file.extension().string());
}

void write_state(const fs::path& file, const StateTree& state, const std::string& version)
{
  write(file, state, version, {});
}

void write_checkpoint(const fs::path& file, const StateTree& state, const std::string& version)
{
  write(file, state, version, previous_of(file));
}

StateTree read_state(const fs::path& file)
{
  std::error_code error;
  std::string fault;
  if (!fs::exists(file, error))
    fault = "is not there";
  else if (!fs::is_regular_file(file, error))
    fault = "is no file";
  std::string bytes;
  if (fault.empty()) {
    bytes = bytes_of(file);
    fault = fault_of(bytes);
  }
  if (!fault.empty()) {
    const fs::path before = previous_of(file);
    std::string sentence = "The state \"" + file.string() + "\" " + fault;
    if (is_good(before))
      sentence +=
          "; the one before, \"" + before.string() + "\", is good: rename it to go on from it";
    throw InputError(sentence + ".");
  }
  return tree_of(bytes.substr(block_size));
}
} // namespace interlock::coupling
