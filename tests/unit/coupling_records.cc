// history.csv and summary.json. It takes a number that reads back differently, a row that is not in
// the file when `add` returns, a run that goes on with other bytes than without the interruption, a
// row torn by a full disk, a temporary file that stays behind, or a hash that loses digits, to
// fail.
#include "coupling/files/atomic_file.h"
#include "coupling/output/history.h"
#include "coupling/output/summary.h"
#include "tests/refusal.h"
#include "tests/small_disk.h"
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
  EXPECT_EQ(history.rows(), 0);
  EXPECT_THROW(History(folder / "missing" / "history.csv", {"time [s]"}), std::runtime_error);
}

TEST_F(Records, HistoryOfANewRunReplacesTheOldOne)
{
  const std::vector<std::string> columns = {"time [s]", "stage"};
  History(folder / "history.csv", columns).add({1.0, "fill"});
  const History history(folder / "history.csv", columns);
  EXPECT_EQ(history.rows(), 0);
  EXPECT_EQ(text_of("history.csv"), "time [s],stage\n");
}

// After row n the run is stopped, has written more rows, torn or whole, than its state knows of,
// and goes on.
TEST_F(Records, HistoryGoesOnWithTheSameBytes)
{
  const std::vector<std::string> columns = {"time [s]", "stage", "force [N]"};
  const auto add = [](History& history, int first, int last) {
    for (int n = first; n < last; ++n) history.add({0.1 * n, n < 4 ? "fill" : "pull", n / 3.});
  };
  {
    History undisturbed(folder / "whole.csv", columns);
    add(undisturbed, 0, 9);
  }
  for (const int rows : {0, 1, 5, 8, 9})
    for (const std::string behind : {"", "0.1", "0.1,fill,1\n", "0.1,fill,1\n7,pu", ",,\n\n\n"}) {
      {
        History first(folder / "cut.csv", columns);
        add(first, 0, rows);
        EXPECT_EQ(first.rows(), rows);
      }
      std::ofstream(folder / "cut.csv", std::ios::app) << behind;
      History second(folder / "cut.csv", columns, rows);
      EXPECT_EQ(second.rows(), rows);
      add(second, rows, 9);
      EXPECT_EQ(second.rows(), 9);
      ASSERT_EQ(text_of("cut.csv"), text_of("whole.csv")) << rows << " rows, then " << behind;
    }
  EXPECT_EQ(number_of_files(), 2u);
}

TEST_F(Records, HistoryRefusesToGoOnWithWhatItDoesNotFit)
{
  const std::vector<std::string> columns = {"time [s]", "stage"};
  const auto go_on = [&](std::int64_t rows) {
    return [=] { History(folder / "history.csv", columns, rows); };
  };
  expect_refusal(go_on(0), "history.csv", {"is not there any more"});
  write("history.csv", "time [s],phase\n1,fill\n");
  expect_refusal(go_on(1), "history.csv", {"other columns"});
  write("history.csv", "time [s],stage"); // torn in the header
  expect_refusal(go_on(0), "history.csv", {"other columns"});
  const std::string two_and_a_half = "time [s],stage\n1,fill\n2,fill\n3,fi";
  write("history.csv", two_and_a_half);
  expect_refusal(go_on(3), "history.csv", {"2 of the 3 rows"});
  EXPECT_EQ(text_of("history.csv"), two_and_a_half); // what is refused is not touched
}

// The row that finds no room is cut off again; once there is room, the next one follows the last
// good one.
TEST_F(Records, FullDiskTearsNoRow)
{
  History history(folder / "history.csv", {"time [s]", "stage"});
  history.add({1.0, "fill"});
  const std::string good = text_of("history.csv");
  for (const int room : {0, 1, 5}) { // bytes left: none, or not enough for the row
    const SmallDisk disk(good.size() + room);
    try {
      history.add({2.0, "settle"});
      ADD_FAILURE() << "written with room for " << room << " bytes";
    } catch (const WriteError& error) {
      const std::string text = error.what(),
                        reason = room > 0 ? "No space left on device" : "File too large";
      EXPECT_NE(text.find((folder / "history.csv").string()), std::string::npos) << text;
      EXPECT_NE(text.find(reason), std::string::npos) << text;
    }
    EXPECT_EQ(text_of("history.csv"), good);
    EXPECT_EQ(history.rows(), 1);
  }
  history.add({3.0, "pull"});
  EXPECT_EQ(text_of("history.csv"), good + "3,pull\n");
  EXPECT_EQ(history.rows(), 2);
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

TEST_F(Records, FullDiskLeavesTheOldFile)
{
  write_atomically(folder / "a.txt", "old");
  try {
    const SmallDisk disk(100);
    write_atomically(folder / "a.txt", std::string(1000, 'x'));
    ADD_FAILURE();
  } catch (const WriteError& error) {
    EXPECT_EQ(std::string(error.what()),
              "the file " + (folder / "a.txt").string() + " cannot be written: File too large");
  }
  EXPECT_EQ(text_of("a.txt"), "old");
  EXPECT_EQ(number_of_files(), 1u);
}

// The old file keeps its bytes under the other name; without an old one there is nothing to keep.
TEST_F(Records, DurableWriteKeepsTheOldFile)
{
  write_durably(folder / "a.txt", "one", folder / "a.previous.txt");
  EXPECT_EQ(text_of("a.txt"), "one");
  EXPECT_EQ(number_of_files(), 1u);
  write_durably(folder / "a.txt", "two", folder / "a.previous.txt");
  write_durably(folder / "a.txt", "three", folder / "a.previous.txt");
  EXPECT_EQ(text_of("a.txt"), "three");
  EXPECT_EQ(text_of("a.previous.txt"), "two");
  EXPECT_EQ(number_of_files(), 2u);
  write_durably(folder / "a.txt", "four");
  EXPECT_EQ(text_of("a.txt"), "four");
  EXPECT_EQ(text_of("a.previous.txt"), "two");
}
