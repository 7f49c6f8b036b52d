// The lines of a `.prm` file with their places, before anybody asks what they mean.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
struct Assignment {
  std::string section; // names of nested subsections joined by "/"; empty at the top level
  std::string name;
  std::string value;
  std::string place;          // "pull.prm, line 12", or "--set"
  std::filesystem::path base; // folder to which a path in the value is relative
  std::filesystem::path file; // the file that was scanned; empty for `--set`

  std::string key() const { return section.empty() ? name : section + "/" + name; }
};

struct ScannedFile {
  std::vector<Assignment> assignments; // one for each entry: what includes a file overrides it
  std::vector<std::string> errors;     // full sentences
};

// Reads the lines `subsection NAME`, `set NAME = VALUE`, `end` and `include FILE` (relative to the
// file that includes it); `#` starts a comment. Errors: a file that cannot be read or includes
// itself, a line of no known kind, a subsection without end, the same entry twice in one file.
ScannedFile scan_parameter_file(const std::filesystem::path& file);

// "Section/Name=value" of the command line. Throws InputError when it has no such form.
Assignment parse_override(const std::string& text);
} // namespace interlock::apps
