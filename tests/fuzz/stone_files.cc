// libFuzzer target: any bytes as a stone file give a mesh, a cloud or an InputError, and nothing
// else. How to build and run it: README.md.
#include "tests/fuzz/any_stone_file.h"

#include <cstdint>

#include <unistd.h>

namespace
{
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
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Folder folder;
  read_any_stone_file({reinterpret_cast<const char*>(data), size}, folder.path);
  return 0;
}
