// The lines of a `.prm` file with their places, before anybody asks what they mean.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace interlock::apps
{
struct Assignment {
  std::string section; // empty at the top level
  std::string name;
  std::string value;          // without quotes around it
  std::string comment;        // behind an unquoted value, with its #
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
// file that includes it). `#` starts a comment, unless it stands in a value in double quotes or
// behind a backslash; a backslash at the end of a line continues it. Errors: a file that cannot be
// read or includes itself, a line of no known kind, a subsection without end (or inside another
// one), the same entry twice in one file.
ScannedFile scan_parameter_file(const std::filesystem::path& file);

// "Section/Name=value" of the command line, where # and quotes are ordinary characters. Throws
// InputError when it has no such form.
Assignment parse_override(const std::string& text);
} // namespace interlock::apps
