// history.csv as a test reads it: one map a row, from the name of a column without its unit.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

inline std::vector<std::map<std::string, double>> history_rows(const std::filesystem::path& folder)
{
  std::ifstream file(folder / "history.csv");
  std::string line, cell;
  std::vector<std::string> names;
  std::vector<std::map<std::string, double>> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::map<std::string, double> row;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (rows.empty() && names.size() <= i)
        names.push_back(cell.substr(0, cell.find(" [")));
      else
        row[names[i]] = std::stod(cell);
    }
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}
