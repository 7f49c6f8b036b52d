// What a fuzzer has kept, and reading all of it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

// File name and bytes of all files of a folder.
inline std::map<std::string, std::string> files_of_corpus(const std::filesystem::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

// Gives the bytes of each file to `read`, which says whether it has taken them and must not throw.
// There must be more than `fewest` files, and one that is taken, or nothing would reach what comes
// behind the reader.
template <class Read>
void expect_read_or_refused(const std::filesystem::path& folder, int fewest, const Read& read)
{
  int files = 0, taken = 0;
  for (const auto& [name, bytes] : files_of_corpus(folder)) {
    EXPECT_NO_THROW(taken += read(bytes)) << name;
    ++files;
  }
  EXPECT_GT(files, fewest);
  EXPECT_GT(taken, 0);
}
