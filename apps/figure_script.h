// Runs one of the scripts that draw figures or the report (apps/*.py) in an environment of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
struct ScriptResult {
  // 0: done. 2: the input holds nothing to draw. Anything else: the script broke, or is not there,
  // or Python is not.
  int status = 0;
  std::string reason; // one full sentence where `status` is not 0
};

// Runs `script` ("figures.py") of the folder apps in shared_folder() (shared_files.h) with
// `arguments`, without a shell, so that they may hold any character. The interpreter is the
// system's, for which Debian packages Matplotlib and h5py, isolated (python3 -I) and without the
// variables that the user's modules, virtual environments and shells export: another Python's
// packages, another HDF5 library, settings of Matplotlib. What the script prints goes to the
// standard output, unless it is to be quiet; the reason is the last line of what it says on its
// error output. An interrupt (interruption.h) ends the script.
ScriptResult run_figure_script(const std::string& script, const std::vector<std::string>& arguments,
                               bool quiet = false);
} // namespace interlock::apps
