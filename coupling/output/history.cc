#include "coupling/output/history.h"

#include "coupling/files/atomic_file.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/join.hpp>

#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

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

std::string header(const std::vector<std::string>& columns)
{
  return boost::algorithm::join(columns, ",") + '\n';
}
} // namespace

History::History(const std::filesystem::path& file, const std::vector<std::string>& columns)
    : file_(file), columns_(columns.size())
{
  write_atomically(file, header(columns));
  open();
}

History::History(const std::filesystem::path& file, const std::vector<std::string>& columns,
                 std::int64_t rows)
    : file_(file), columns_(columns.size()), rows_(rows)
{
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError("The run cannot go on: its \"" + file.string() + "\" is not there any more.");
  std::ostringstream whole;
  whole << in.rdbuf();
  const std::string text = whole.str(), head = header(columns);
  if (text.compare(0, head.size(), head) != 0)
    throw InputError("The run cannot go on: \"" + file.string() + "\" has other columns than it.");
  std::size_t end = head.size();
  for (std::int64_t row = 0; row < rows; ++row) {
    end = text.find('\n', end);
    if (end == std::string::npos)
      throw InputError("The run cannot go on: \"" + file.string() + "\" has " +
                       std::to_string(row) + " of the " + std::to_string(rows) +
                       " rows that it had when the state was written.");
    ++end;
  }
  write_atomically(file, text.substr(0, end));
  open();
}

History::~History()
{
  if (descriptor_ >= 0) ::close(descriptor_);
}

void History::open()
{
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) throw WriteError(file_);
}

void History::add(const std::vector<Cell>& row)
{
  if (row.size() != columns_)
    throw std::invalid_argument("a row of the history has " + std::to_string(row.size()) +
                                " cells instead of " + std::to_string(columns_));
  std::string line;
  for (const Cell& cell : row) line += (line.empty() ? "" : ",") + text_of(cell);
  line += '\n';
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  const ssize_t written = ::write(descriptor_, line.data(), line.size());
  if (written != static_cast<ssize_t>(line.size())) {
    if (written >= 0) errno = ENOSPC; // a part only: there was no room for the rest
    const WriteError error(file_);
    // A torn row that cannot be cut off either is cut off when the run goes on.
    [[maybe_unused]] const int cut = written > 0 ? ::ftruncate(descriptor_, before) : 0;
    throw error;
  }
  ++rows_;
}
} // namespace interlock::coupling
