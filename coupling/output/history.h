// history.csv: one row for each record of a run.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
// The file can be read and plotted while the run goes on: it takes its final name as soon as its
// header is complete and then grows by whole rows, each flushed at once.
class History
{
public:
  using Cell = std::variant<double, std::string>; // text: a word such as the name of the stage

  // `columns` are the headers, "name [unit]" with the name in lower_case: "pull_force [N]".
  // Replaces a file of an earlier run. Throws std::runtime_error when the file cannot be written.
  History(const std::filesystem::path& file, const std::vector<std::string>& columns);

  // One cell for each column; numbers are written with the digits that give the same double again.
  // Throws std::invalid_argument for another number of cells or a text with a comma in it, and
  // std::runtime_error when the disk is full.
  void add(const std::vector<Cell>& row);

private:
  std::filesystem::path file_;
  std::size_t columns_;
  std::ofstream stream_;
};
} // namespace interlock::coupling
