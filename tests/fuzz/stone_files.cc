// libFuzzer target: any bytes as a stone file give a mesh, a cloud or an InputError, and nothing
// else. The first byte chooses the extension. Usage: tests/fuzz/README.md.
#include "dem/input_error.h"
#include "dem/point_cloud.h"

#include <cstdint>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace
{
using namespace interlock;

// Removed when the fuzzer ends; in memory where the system has such a folder.
struct Folder {
  Folder()
      : path(std::filesystem::path(std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") /
             ("interlock_fuzz_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(path);
  }
  ~Folder()
  {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
  std::filesystem::path path;
};

template <class Reader> void read(const Reader& reader)
{
  try {
    reader();
  } catch (const InputError&) {
  }
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Folder folder;
  static const char* const extensions[] = {".stl", ".ply", ".obj", ".xyz"};
  if (size == 0) return 0;
  const std::string path = (folder.path / "stone").string() + extensions[data[0] % 4];
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  dem::StoneFileOptions options;
  options.flip = data[0] & 4;
  read([&] { dem::read_stone_mesh(path, options); });
  if (dem::is_point_cloud(path)) read([&] { dem::read_point_cloud(path, options); });
  return 0;
}
