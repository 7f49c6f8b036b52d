#include "apps/clump_files.h"

#include "apps/output_folder.h"
#include "dem/input_error.h"
#include "dem/scans/stone_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

// The stones of a folder, by name.
std::vector<std::string> stones_in(const std::string& folder)
{
  std::vector<std::string> stones;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (dem::is_stone_file(*entry, dem::stone_endings)) stones.push_back(entry->path().string());
  if (error) throw InputError("The folder '" + folder + "' cannot be read.");
  if (stones.empty())
    throw InputError("The folder '" + folder +
                     "' has no .stl, .ply, .obj or .xyz file in it (names that start with a dot "
                     "do not count).");
  std::sort(stones.begin(), stones.end());
  return stones;
}

std::vector<std::string> stone_files(const std::vector<std::string>& arguments)
{
  std::vector<std::string> files;
  std::error_code error;
  for (const std::string& argument : arguments)
    if (fs::is_directory(argument, error))
      for (const std::string& stone : stones_in(argument)) files.push_back(stone);
    else
      files.push_back(argument);
  return files;
}

// One name for one file, whatever links and dots lead to it.
fs::path canonical(const fs::path& path)
{
  std::error_code error;
  const fs::path absolute = fs::absolute(path);
  const fs::path found = fs::weakly_canonical(absolute, error);
  return (error ? absolute : found).lexically_normal();
}

// Who is where already, so that nothing is written over a stone or over another output.
class TakenPlaces
{
public:
  void add_stone(const std::string& path)
  {
    taken_[canonical(path)] = "that is the stone '" + path + "'";
  }

  // An output must not lie inside another one either: some are folders.
  void add_output(const std::string& what, const std::string& path)
  {
    const fs::path place = canonical(path);
    for (fs::path at = place; at.has_relative_path(); at = at.parent_path())
      if (const auto found = taken_.find(at); found != taken_.end())
        throw InputError(capital(what) + " cannot be written to '" + path + "': " + found->second +
                         "; choose another name.");
    taken_[place] = what + " goes there";
    // One file stands for all of a folder.
    if (folders_.insert(place.parent_path()).second) check_writable("The file", path);
  }

private:
  static std::string capital(std::string text)
  {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
  }

  std::map<fs::path, std::string> taken_;
  std::set<fs::path> folders_;
};

std::string clump_of(const std::string& name, const ClumpArguments& arguments, bool several)
{
  const std::string file = name + ".clump.json";
  if (arguments.output.empty()) return file;
  std::error_code error;
  const bool is_folder =
      several || arguments.output.back() == '/' || fs::is_directory(arguments.output, error);
  return is_folder ? (fs::path(arguments.output) / file).string() : arguments.output;
}

StoneFiles files_of(const std::string& stone, const ClumpArguments& arguments, bool several)
{
  StoneFiles files;
  files.stone = stone;
  files.name = fs::path(stone).stem().string();
  files.clump = clump_of(files.name, arguments, several);
  std::set<std::string> known;
  for (const std::string& name : arguments.formats)
    if (known.insert(name).second) {
      const dem::ClumpFormat format = dem::clump_format(name);
      files.exports.push_back({name, dem::clump_export_path(files.clump, format), format});
    }
  return files;
}

std::string report_of(const ClumpFiles& files, const ClumpArguments& arguments)
{
  if (!arguments.report.empty()) return arguments.report;
  if (files.folder.empty()) return dem::clump_stem(files.stones.front().clump) + ".report.json";
  return (fs::path(files.folder) / "clumps.report.json").string();
}

// Whoever types the name of a scan behind -o or --report does not want to lose it.
void refuse_name_of_stone(const std::string& what, const std::string& path)
{
  std::error_code error;
  if (is_named_as_stone(path))
    throw InputError(what + " '" + path +
                     "' is named as a stone, but must not end with .stl, .ply, .obj or .xyz.");
  if (fs::is_directory(path, error))
    throw InputError(what + " '" + path + "' cannot be written: it is a folder.");
}

void check_places(const ClumpFiles& files)
{
  TakenPlaces places;
  for (const StoneFiles& stone : files.stones) places.add_stone(stone.stone);
  for (const StoneFiles& stone : files.stones) {
    const std::string of = " of '" + stone.stone + "'";
    places.add_output("the clump" + of, stone.clump);
    for (const ExportFile& file : stone.exports)
      for (const std::string& path : dem::clump_export_paths(stone.clump, file.format))
        places.add_output("the " + file.format_name + " file" + of, path);
  }
  places.add_output("the report", files.report);
  for (const StoneFiles& stone : files.stones) refuse_name_of_stone("The clump", stone.clump);
  refuse_name_of_stone("The report", files.report);
}
} // namespace

bool is_named_as_stone(const std::string& path)
{
  return dem::has_ending(path, dem::stone_endings);
}

ClumpFiles plan_clump_files(const ClumpArguments& arguments)
{
  const std::vector<std::string> stones = stone_files(arguments.stones);
  if (stones.empty()) throw InputError("No stone is given: interlock clump STONE... (--help).");
  const bool several = stones.size() > 1;
  if (several && arguments.output.empty())
    throw InputError("Several stones need a folder for their clumps: --output FOLDER.");
  ClumpFiles files;
  if (several) files.folder = arguments.output;
  for (const std::string& stone : stones)
    files.stones.push_back(files_of(stone, arguments, several));
  files.report = report_of(files, arguments);
  check_places(files);
  return files;
}
} // namespace interlock::apps
