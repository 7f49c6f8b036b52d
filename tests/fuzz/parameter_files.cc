// libFuzzer target: any bytes as a parameter file give parameters or an InputError, and nothing
// else. How to build and run it: README.md.
#include "tests/fuzz/any_parameter_file.h"
#include "tests/fuzz/fuzz_folder.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const FuzzFolder folder;
  read_any_parameter_file({reinterpret_cast<const char*>(data), size}, folder.path());
  return 0;
}
