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
  int files = 0, lattices = 0;
  for (const auto& [name, bytes] :
       files_of_corpus(INTERLOCK_SOURCE_DIR "/tests/fuzz/corpus/lattices")) {
    EXPECT_NO_THROW(lattices += read_any_lattice_file(bytes, folder)) << name;
    ++files;
  }
  EXPECT_GT(files, 10);
  EXPECT_GT(lattices, 0); // or nothing would reach what comes behind the reader
}
} // namespace
