// libFuzzer target: any bytes as a stone file give a mesh, a cloud or an InputError, and nothing
// else. How to build and run it: README.md.
#include "tests/fuzz/any_stone_file.h"
#include "tests/fuzz/fuzz_folder.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const FuzzFolder folder;
  read_any_stone_file({reinterpret_cast<const char*>(data), size}, folder.path());
  return 0;
}
