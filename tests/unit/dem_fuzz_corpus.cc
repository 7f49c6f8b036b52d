// Every stone file that the fuzzer found to reach something new is read as a mesh or a cloud, or
// refused. Fails when a reader crashes, hangs (the time limit of ctest) or throws anything but
// InputError.
#include "tests/fuzz/any_stone_file.h"
#include "tests/fuzz/files_of_corpus.h"
#include "tests/temporary_folder.h"

namespace
{
class StoneCorpus : public TemporaryFolderTest
{
};

TEST_F(StoneCorpus, EveryFileIsReadOrRefused)
{
  int files = 0, meshes = 0, clouds = 0;
  for (const auto& [name, bytes] :
       files_of_corpus(INTERLOCK_SOURCE_DIR "/tests/fuzz/corpus/stones")) {
    Outcome outcome;
    EXPECT_NO_THROW(outcome = read_any_stone_file(bytes, folder)) << name;
    ++files;
    meshes += outcome.is_mesh;
    clouds += outcome.is_cloud;
  }
  // The corpus also holds sound files, or it would not reach what comes behind the readers.
  EXPECT_GT(files, 50);
  EXPECT_GT(meshes, 0);
  EXPECT_GT(clouds, 0);
}
} // namespace
