// libFuzzer target: any bytes as a Gmsh file give a lattice or one sentence, and nothing else. How
// to build and run it: README.md.
#include "tests/fuzz/any_lattice_file.h"
#include "tests/fuzz/fuzz_folder.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const FuzzFolder folder;
  read_any_lattice_file({reinterpret_cast<const char*>(data), size}, folder.path());
  return 0;
}
