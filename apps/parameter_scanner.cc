#include "apps/parameter_scanner.h"

#include "apps/text_lines.h"
#include "dem/input_error.h"

#include <boost/algorithm/string.hpp>

#include <algorithm>
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

// A line without its comment, and the comment with its `#`. `#` is an ordinary character between
// double quotes and behind a backslash.
std::pair<std::string, std::string> without_comment(const std::string& line)
{
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == '#' && !quoted && (i == 0 || line[i - 1] != '\\'))
      return {line.substr(0, i), line.substr(i)};
  }
  return {line, ""};
}

// A value as it is meant: without the quotes around it, and with # for \#.
std::string plain_value(std::string value)
{
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
    return value.substr(1, value.size() - 2);
  return boost::replace_all_copy(value, "\\#", "#");
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
    std::string whole, whole_comment; // of a line that goes on behind a backslash
    for (const std::string& text : read_text_lines(file_)) {
      ++lines_read_;
      auto [line, comment] = without_comment(text);
      boost::trim(line);
      if (whole.empty()) line_number_ = lines_read_;
      const bool goes_on = boost::ends_with(line, "\\");
      if (goes_on) line.pop_back();
      whole += line;
      whole_comment += comment;
      if (goes_on) continue;
      boost::trim(whole);
      if (!whole.empty()) read_line(whole, whole_comment);
      whole.clear();
      whole_comment.clear();
    }
    if (!whole.empty()) read_line(boost::trim_copy(whole), whole_comment);
    if (!section_.empty()) never_ends();
  }

private:
  std::string place() const { return file_.string() + ", line " + std::to_string(line_number_); }

  void error(const std::string& sentence) { result_.errors.push_back(place() + ": " + sentence); }

  void never_ends()
  {
    result_.errors.push_back(section_place_ + ": the subsection \"" + section_ +
                             "\" has no \"end\".");
  }

  void read_line(const std::string& line, const std::string& comment)
  {
    if (const auto assignment = after("set", line))
      read_assignment(*assignment, comment);
    else if (const auto name = after("subsection", line))
      open_section(*name);
    else if (const auto included = after("include", line))
      include(plain_value(*included));
    else if (line == "end" && section_.empty())
      error("this \"end\" closes no subsection.");
    else if (line == "end")
      section_.clear();
    else
      error("the line \"" + line +
            "\" is none of \"set NAME = VALUE\", \"subsection NAME\", \"end\", \"include FILE\".");
  }

  // Sections do not nest: one that is still open has lost its end, and whatever follows is meant
  // for the next one.
  void open_section(const std::string& name)
  {
    if (!section_.empty()) never_ends();
    section_ = name;
    section_place_ = place();
  }

  void read_assignment(const std::string& text, const std::string& comment)
  {
    const auto equals = text.find('=');
    if (equals == std::string::npos || boost::trim_copy(text.substr(0, equals)).empty())
      return error("\"set " + text + "\" lacks the name, or the \"=\" between name and value.");
    const std::string value = boost::trim_copy(text.substr(equals + 1));
    store({section_, boost::trim_copy(text.substr(0, equals)), plain_value(value),
           boost::starts_with(value, "\"") ? "" : comment, place(), file_.parent_path(), file_});
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
    if (!section_.empty()) return error("\"include\" must stand outside all subsections.");
    if (!fs::exists(included))
      return error("the included file \"" + included.string() +
                   "\" does not exist; a case that includes another one needs it at that place.");
    if (std::find(chain_.begin(), chain_.end(), fs::weakly_canonical(included)) != chain_.end())
      return error("the file \"" + included.string() + "\" includes itself.");
    Scanner(included, chain_, result_).scan();
  }

  fs::path file_;
  std::vector<fs::path> chain_; // this file and those that include it, to find circles
  ScannedFile& result_;
  int lines_read_ = 0, line_number_ = 0; // the second one: where the present statement began
  std::string section_, section_place_;  // the open subsection; empty: none
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
  assignment.value = boost::trim_copy(text.substr(equals + 1)); // no comments on a command line
  assignment.place = "--set";
  assignment.base = fs::current_path();
  return assignment;
}
} // namespace interlock::apps
