// history.csv and summary.json. It takes a number that reads back differently, a row that is not in
// the file when `add` returns, a temporary file that stays behind, or a hash that loses digits, to
// fail.
#include "coupling/files/atomic_file.h"
#include "coupling/output/history.h"
#include "coupling/output/summary.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

using namespace interlock::coupling;
namespace fs = std::filesystem;

namespace
{
class Records : public TemporaryFolderTest
{
protected:
  std::string text_of(const std::string& name) const
  {
    std::ifstream stream(folder / name);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  std::size_t number_of_files() const
  {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }
};
} // namespace

TEST_F(Records, HistoryCanBeReadAfterEachRow)
{
  History history(folder / "history.csv", {"time [s]", "pull_force [N]", "stage"});
  EXPECT_EQ(text_of("history.csv"), "time [s],pull_force [N],stage\n");
  history.add({0.0, 1250.5, "pull"});
  EXPECT_EQ(text_of("history.csv"), "time [s],pull_force [N],stage\n0,1250.5,pull\n");
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Records, HistoryKeepsEveryDigit)
{
  const std::vector<double> numbers = {0.1, 1. / 3, 2.5e-17, -1e300, 123456789.123456789};
  History history(folder / "history.csv", {"a [-]", "b [-]", "c [-]", "d [-]", "e [-]"});
  history.add({numbers.begin(), numbers.end()});
  std::istringstream text(text_of("history.csv"));
  std::string cell;
  std::getline(text, cell); // header
  for (const double number : numbers) {
    std::getline(text, cell, ',');
    EXPECT_EQ(std::strtod(cell.c_str(), nullptr), number);
  }
}

TEST_F(Records, HistoryRefusesRowsThatDoNotFitItsColumns)
{
  History history(folder / "history.csv", {"time [s]", "stage"});
  EXPECT_THROW(history.add({1.0}), std::invalid_argument);
  EXPECT_THROW(history.add({1.0, "fill, then settle"}), std::invalid_argument);
  EXPECT_EQ(text_of("history.csv"), "time [s],stage\n");
  EXPECT_THROW(History(folder / "missing" / "history.csv", {"time [s]"}), std::runtime_error);
}

TEST_F(Records, SummaryHoldsWhatTheRunWas)
{
  Summary summary;
  summary.experiment = "pull-out";
  summary.steps = 2000;
  summary.wall_time = 1;
  summary.stages = {{"settle", 500, 0.01, 0.2}, {"pull", 1500, 0.03, 0.8}};
  summary.energy["work_of_clamp"] = 12.5;
  summary.energy["relative_error"] = std::numeric_limits<double>::quiet_NaN();
  summary.warnings = {"The time step is large."};
  summary.state_hash = 0x0123456789abcdef; // more digits than a double has
  write_summary(folder / "summary.json", summary);

  const auto json = nlohmann::json::parse(text_of("summary.json"));
  EXPECT_EQ(json.at("experiment"), "pull-out");
  EXPECT_EQ(json.at("wall_time_per_step_s"), 0.0005);
  EXPECT_EQ(json.at("stages").at(1).at("name"), "pull");
  EXPECT_EQ(json.at("stages").at(1).at("simulated_time_s"), 0.03);
  EXPECT_EQ(json.at("energy").at("work_of_clamp"), 12.5);
  EXPECT_TRUE(json.at("energy").at("relative_error").is_null());
  EXPECT_TRUE(json.at("results").is_object());
  EXPECT_EQ(json.at("warnings").at(0), "The time step is large.");
  EXPECT_EQ(json.at("state_hash"), "0123456789abcdef");
  EXPECT_EQ(number_of_files(), 1u);
}

// A directory in the way of the temporary name stands for a disk that cannot be written.
TEST_F(Records, AtomicWriteLeavesTheOldFileWhenItFails)
{
  write_atomically(folder / "a.txt", "old");
  fs::create_directory(folder / "a.txt.part");
  EXPECT_THROW(write_atomically(folder / "a.txt", "new"), std::runtime_error);
  EXPECT_EQ(text_of("a.txt"), "old");
}
