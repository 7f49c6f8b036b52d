// Which file of the clump command goes where: decided, and refused, before any work.
#pragma once

#include "dem/export/clump_export.h"

#include <string>
#include <vector>

namespace interlock::apps
{
struct ExportFile {
  std::string format_name, path;
  dem::ClumpFormat format;
};

struct StoneFiles {
  std::string stone; // as it was given, or FOLDER/FILE
  std::string name;  // of the stone: its file's name without the extension
  std::string clump;
  std::vector<ExportFile> exports;
};

struct ClumpFiles {
  std::vector<StoneFiles> stones;
  std::string folder; // of the clumps of several stones; empty for one stone
  std::string report;
};

// The arguments as they were typed; empty where none was.
struct ClumpArguments {
  std::vector<std::string> stones; // files, and folders of them
  std::string output, report;
  std::vector<std::string> formats;
};

// Whether the name ends as those of stones do: .stl, .ply, .obj or .xyz in any case.
bool is_named_as_stone(const std::string& path);

// One stone: `output` is its clump file, or a folder that exists or ends with a slash;
// NAME.clump.json here without it. Several stones: `output` is the folder. The report goes beside
// the clumps. Throws InputError with one sentence naming both when an output is a stone or another
// output (links followed), when it is named as a stone, when it cannot be written, or when a folder
// has no stone. Changes nothing on the disk.
ClumpFiles plan_clump_files(const ClumpArguments& arguments);
} // namespace interlock::apps
