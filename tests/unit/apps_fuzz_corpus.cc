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
  expect_read_or_refused(
      INTERLOCK_SOURCE_DIR "/tests/fuzz/corpus/parameters", 20,
      [&](const std::string& bytes) { return read_any_parameter_file(bytes, folder); });
}
} // namespace
