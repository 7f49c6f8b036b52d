// history.csv: one row for each record of a run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
// The file can be read and plotted while the run goes on: it takes its final name as soon as its
// header is complete and then grows by whole rows, each handed to the system at once.
class History
{
public:
  using Cell = std::variant<double, std::string>; // text: a word such as the name of the stage

  // `columns` are the headers, "name [unit]" with the name in lower_case: "pull_force [N]".
  // Replaces a file of an earlier run. Throws std::runtime_error, with the reason, when the file
  // cannot be written.
  History(const std::filesystem::path& file, const std::vector<std::string>& columns);

  // Goes on with the file of the same run: keeps its first `rows` rows and cuts off what is behind
  // them, a torn row included. Throws InputError, one sentence, when the file is not there, has
  // other columns or fewer rows.
  History(const std::filesystem::path& file, const std::vector<std::string>& columns,
          std::int64_t rows);

  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  // One cell for each column; numbers are written with the digits that give the same double again.
  // Throws std::invalid_argument for another number of cells or a text with a comma in it, and
  // std::runtime_error, with the reason, when the disk is full; the row is cut off again then.
  void add(const std::vector<Cell>& row);

  std::int64_t rows() const { return rows_; }

private:
  void open();

  std::filesystem::path file_;
  std::size_t columns_;
  std::int64_t rows_ = 0;
  int descriptor_ = -1;
};
} // namespace interlock::coupling
