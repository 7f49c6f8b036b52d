// libFuzzer target: any bytes as a Gmsh file give a lattice or one sentence, and nothing else. How
// to build and run it: README.md.
#include "tests/fuzz/any_lattice_file.h"
#include "tests/fuzz/fuzz_folder.h"

#include <gmsh.h>

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const FuzzFolder folder;
  // Before there is a child: Gmsh takes a while to start.
  static const bool ready = [] {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    return true;
  }();
  if (!ready) return 0;
  read_any_lattice_file({reinterpret_cast<const char*>(data), size}, folder.path());
  return 0;
}
