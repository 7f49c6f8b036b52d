#include "apps/parameter_scanner.h"

#include "dem/input_error.h"

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <fstream>
#include <optional>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

// The rest of a line that starts with a keyword and a space.
std::optional<std::string> after(const std::string& keyword, const std::string& line)
{
  if (!boost::starts_with(line, keyword) || line.size() <= keyword.size() ||
      !std::isspace(static_cast<unsigned char>(line[keyword.size()])))
    return {};
  return boost::trim_copy(line.substr(keyword.size()));
}

// One file; the files that it includes get a scanner of their own with a longer chain of parents.
class Scanner
{
public:
  Scanner(const fs::path& file, std::vector<fs::path> parents, ScannedFile& result)
      : file_(file), chain_(std::move(parents)), result_(result)
  {
    chain_.push_back(fs::weakly_canonical(file));
  }

  void scan()
  {
    std::ifstream stream(file_);
    if (fs::is_directory(file_) || !stream)
      throw InputError("The parameter file \"" + file_.string() + "\" cannot be read.");
    std::string line;
    while (std::getline(stream, line)) {
      ++line_number_;
      line = boost::trim_copy(line.substr(0, line.find('#')));
      if (!line.empty()) read_line(line);
    }
    for (const auto& [name, place] : open_)
      result_.errors.push_back(place + ": the subsection \"" + name + "\" has no \"end\".");
  }

private:
  std::string place() const { return file_.string() + ", line " + std::to_string(line_number_); }

  void error(const std::string& sentence) { result_.errors.push_back(place() + ": " + sentence); }

  void read_line(const std::string& line)
  {
    if (const auto assignment = after("set", line))
      read_assignment(*assignment);
    else if (const auto name = after("subsection", line))
      open_.emplace_back(*name, place());
    else if (const auto included = after("include", line))
      include(*included);
    else if (line == "end" && open_.empty())
      error("this \"end\" closes no subsection.");
    else if (line == "end")
      open_.pop_back();
    else
      error("the line \"" + line +
            "\" is none of \"set NAME = VALUE\", \"subsection NAME\", \"end\", \"include FILE\".");
  }

  void read_assignment(const std::string& text)
  {
    const auto equals = text.find('=');
    if (equals == std::string::npos || boost::trim_copy(text.substr(0, equals)).empty())
      return error("\"set " + text + "\" lacks the name, or the \"=\" between name and value.");

    std::vector<std::string> sections;
    for (const auto& opened : open_) sections.push_back(opened.first);
    store({boost::join(sections, "/"), boost::trim_copy(text.substr(0, equals)),
           boost::trim_copy(text.substr(equals + 1)), place(), file_.parent_path(), file_});
  }

  // Twice in one file is a slip; once here and once in an included file is an override.
  void store(const Assignment& assignment)
  {
    const auto same_entry = [&](const Assignment& other) {
      return other.key() == assignment.key();
    };
    const auto before =
        std::find_if(result_.assignments.begin(), result_.assignments.end(), same_entry);
    if (before == result_.assignments.end())
      result_.assignments.push_back(assignment);
    else if (before->file == file_)
      error("the entry \"" + assignment.key() + "\" was set before, in " + before->place + ".");
    else
      *before = assignment;
  }

  void include(const std::string& name)
  {
    const fs::path included = file_.parent_path() / name;
    if (!open_.empty()) return error("\"include\" must stand outside all subsections.");
    if (!fs::exists(included))
      return error("the included file \"" + included.string() + "\" does not exist.");
    if (std::find(chain_.begin(), chain_.end(), fs::weakly_canonical(included)) != chain_.end())
      return error("the file \"" + included.string() + "\" includes itself.");
    Scanner(included, chain_, result_).scan();
  }

  fs::path file_;
  std::vector<fs::path> chain_; // this file and those that include it, to find circles
  ScannedFile& result_;
  int line_number_ = 0;
  std::vector<std::pair<std::string, std::string>> open_; // subsections: name and place
};
} // namespace

ScannedFile scan_parameter_file(const fs::path& file)
{
  ScannedFile result;
  Scanner(file, {}, result).scan();
  return result;
}

Assignment parse_override(const std::string& text)
{
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--set \"" + text + "\" must have the form \"Section/Name=value\".");
  const std::string key = boost::trim_copy(text.substr(0, equals));
  const auto slash = key.rfind('/');
  Assignment assignment;
  assignment.section = slash == std::string::npos ? "" : boost::trim_copy(key.substr(0, slash));
  assignment.name = boost::trim_copy(slash == std::string::npos ? key : key.substr(slash + 1));
  assignment.value = boost::trim_copy(text.substr(equals + 1));
  assignment.place = "--set";
  assignment.base = fs::current_path();
  return assignment;
}
} // namespace interlock::apps
