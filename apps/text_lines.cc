#include "apps/text_lines.h"

#include "dem/input_error.h"

#include <boost/algorithm/string.hpp>

#include <fstream>
#include <iterator>

namespace interlock::apps
{
namespace
{
// In UTF-8: no-break space, the spaces of U+2000 to U+200A, narrow no-break, mathematical and
// ideographic space.
const std::vector<std::string> spaces = {"\u00A0", "\u2000", "\u2001", "\u2002", "\u2003",
                                         "\u2004", "\u2005", "\u2006", "\u2007", "\u2008",
                                         "\u2009", "\u200A", "\u202F", "\u205F", "\u3000"};
// Zero-width space, joiners, word joiner, soft hyphen, and the byte order mark, which is one too.
const std::vector<std::string> without_width = {"\u200B", "\u200C", "\u200D",
                                                "\u2060", "\u00AD", "\uFEFF"};

std::string bytes_of(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::error_code error;
  if (std::filesystem::is_directory(file, error) || !stream)
    throw InputError("The parameter file \"" + file.string() + "\" cannot be read.");
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_utf16(const std::string& text)
{
  return boost::starts_with(text, "\xFF\xFE") || boost::starts_with(text, "\xFE\xFF");
}
} // namespace

std::vector<std::string> read_text_lines(const std::filesystem::path& file)
{
  std::string text = bytes_of(file);
  if (is_utf16(text))
    throw InputError("The parameter file \"" + file.string() +
                     "\" is written in UTF-16 (\"Unicode\" of some editors); save it as UTF-8.");
  for (const std::string& space : spaces) boost::replace_all(text, space, " ");
  for (const std::string& nothing : without_width) boost::replace_all(text, nothing, "");
  boost::replace_all(text, "\r\n", "\n");
  boost::replace_all(text, "\r", "\n");
  std::vector<std::string> lines;
  boost::split(lines, text, boost::is_any_of("\n"));
  if (lines.back().empty()) lines.pop_back();
  return lines;
}
} // namespace interlock::apps
