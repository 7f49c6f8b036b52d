// Every Gmsh file that the fuzzer found to reach something new is read as a lattice, or refused.
// Fails when the reader crashes, hangs (the time limit of ctest) or throws anything but
// std::runtime_error.
#include "tests/fuzz/any_lattice_file.h"
#include "tests/fuzz/files_of_corpus.h"
#include "tests/temporary_folder.h"

namespace
{
class LatticeCorpus : public TemporaryFolderTest
{
};

TEST_F(LatticeCorpus, EveryFileIsReadOrRefused)
{
  expect_read_or_refused(
      INTERLOCK_SOURCE_DIR "/tests/fuzz/corpus/lattices", 10,
      [&](const std::string& bytes) { return read_any_lattice_file(bytes, folder); });
}
} // namespace
