// The output folder of a run and its owner: one run at a time writes there, and none writes over
// the results of another one unasked.
#pragma once

#include <filesystem>

namespace interlock::apps
{
// A file in a folder that `interlock drop` has made inside that of a run, and may remove again.
inline constexpr const char* second_pull_mark = "second_pull.txt";

enum class FolderUse {
  fresh,   // of a run that must not find results
  replace, // of one that may remove those of an earlier run
  resume   // of one that goes on with what is there
};

class RunFolder
{
public:
  // Throws InputError, one sentence, when the folder has no name or is a file, when another run is
  // writing there, or when a fresh run would find a finished or a stopped one. Changes nothing.
  RunFolder(std::filesystem::path folder, FolderUse use);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  // Makes the folder and owns it until this object is gone. Removes what an earlier run has left,
  // by the names that runs give to their files, unless this one goes on with it. Throws InputError
  // when another run was faster or the disk does not allow it.
  void take();

  const std::filesystem::path& path() const { return folder_; }

private:
  void lock(bool make);

  std::filesystem::path folder_;
  FolderUse use_;
  // Of run.log, locked as long as it is open: also where a constructor above has thrown.
  struct Descriptor {
    int number = -1;
    void close();
    ~Descriptor() { close(); }
  } lock_;
};
} // namespace interlock::apps
