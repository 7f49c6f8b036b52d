// A test fixture with an empty folder of its own, removed when the test ends.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

class TemporaryFolderTest : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::path(testing::TempDir()) /
             (std::string("interlock_") + test.test_suite_name() + "_" + test.name() + "_" +
              std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  // Writes a small file into the folder and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder / name) << text;
    return folder / name;
  }

  static std::string file_text(const std::filesystem::path& file)
  {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path folder;
};
