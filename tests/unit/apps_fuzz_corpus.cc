// Every parameter file that the fuzzer found to reach something new is read, or refused. Fails when
// the reader crashes, hangs (the time limit of ctest), throws anything but InputError, or writes
// down other parameters than it has taken.
#include "tests/fuzz/any_parameter_file.h"
#include "tests/fuzz/files_of_corpus.h"
#include "tests/temporary_folder.h"

namespace
{
class ParameterCorpus : public TemporaryFolderTest
{
};

TEST_F(ParameterCorpus, EveryFileIsReadOrRefused)
{
  int files = 0, taken = 0;
  for (const auto& [name, bytes] :
       files_of_corpus(INTERLOCK_SOURCE_DIR "/tests/fuzz/corpus/parameters")) {
    EXPECT_NO_THROW(taken += read_any_parameter_file(bytes, folder)) << name;
    ++files;
  }
  EXPECT_GT(files, 20);
  EXPECT_GT(taken, 0); // or nothing would reach what comes behind the reader
}
} // namespace
