#include "coupling/output/history.h"

#include <boost/algorithm/string/join.hpp>

#include <array>
#include <charconv>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
// Shortest text that reads back as the same double, whatever the locale.
std::string text_of(const double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string text_of(const History::Cell& cell)
{
  if (const double* value = std::get_if<double>(&cell)) return text_of(*value);
  const std::string& text = std::get<std::string>(cell);
  if (text.find_first_of(",\"\n") != std::string::npos)
    throw std::invalid_argument("a cell of the history must not hold a comma: " + text);
  return text;
}
} // namespace

History::History(const std::filesystem::path& file, const std::vector<std::string>& columns)
    : file_(file), columns_(columns.size())
{
  const std::filesystem::path part = file.string() + ".part";
  stream_.open(part);
  stream_ << boost::algorithm::join(columns, ",") << '\n' << std::flush;
  if (!stream_) throw std::runtime_error("the file " + part.string() + " cannot be written");
  std::filesystem::rename(part, file); // the open stream follows the file to its new name
}

void History::add(const std::vector<Cell>& row)
{
  if (row.size() != columns_)
    throw std::invalid_argument("a row of the history has " + std::to_string(row.size()) +
                                " cells instead of " + std::to_string(columns_));
  std::string line;
  for (const Cell& cell : row) line += (line.empty() ? "" : ",") + text_of(cell);
  stream_ << line + '\n' << std::flush;
  if (!stream_) throw std::runtime_error("the file " + file_.string() + " cannot be written");
}
} // namespace interlock::coupling
