// The contact forces of a drop: frames at given displacements, and `interlock drop` from a finished
// pull to its figure. It takes a digit of the pull that frames change, a frame at another place, a
// second pull with other digits that is drawn, or a figure that is not there, to fail.
#include "tests/history_rows.h"
#include "tests/stopped_run.h"

#include <cstdlib>

using namespace stopped_run;

namespace
{
class DropOfForce : public StoppedRunTest
{
protected:
  Ending drop(const std::string& options) const
  {
    const std::string command =
        "cd '" + folder.string() + "' && '" INTERLOCK_PROGRAM "' drop " + options + " >out 2>err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "out"),
            text_of(folder / "err")};
  }

  std::size_t frames(const std::string& output) const
  {
    const fs::path there = folder / output / "frames";
    std::size_t n = 0;
    for (const auto& entry : fs::directory_iterator(there))
      if (entry.path().filename().string().compare(0, 9, "contacts_") == 0) ++n;
    return n;
  }

  // When the frames of a series were taken [s], as its XDMF file says.
  std::vector<double> times(const std::string& output) const
  {
    const std::string text = text_of(folder / output / "geogrid.xdmf");
    std::vector<double> found;
    const std::string mark = "<Time Value=\"";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
      found.push_back(std::strtod(text.c_str() + at + mark.size(), nullptr));
    return found;
  }
};
} // namespace

TEST_F(DropOfForce, FramesAtDisplacementsChangeNoDigit)
{
  const json plain = summary_of_run(pull_out("plain"));
  const auto rows = history_rows(folder / "plain");
  std::ostringstream places; // two records, and the way between two others
  places.precision(17);
  const double between = 0.5 * (rows[20].at("displacement") + rows[21].at("displacement"));
  places << "Output/Frames at=" << rows[7].at("displacement") << ", " << between << ", "
         << rows[25].at("displacement");
  const json framed = summary_of_run(pull_out("framed", {places.str(), "Output/Field frames=0"}));
  EXPECT_EQ(framed["state_hash"], plain["state_hash"]);
  EXPECT_TRUE(text_of(folder / "framed/history.csv") == text_of(folder / "plain/history.csv"));
  const std::vector<double> at = times("framed");
  ASSERT_EQ(at.size(), 3u);
  EXPECT_EQ(at[0], rows[7].at("time"));
  EXPECT_EQ(at[2], rows[25].at("time"));
  const double step = plain["time_step_s"].get<double>();
  EXPECT_NEAR(at[1], 0.5 * (rows[20].at("time") + rows[21].at("time")), 2 * step);
}

TEST_F(DropOfForce, IsDrawnFromASecondPullWithTheSameDigits)
{
  summary_of_run(pull_out("run"));
  const auto first = results("run");
  const Ending ending = drop("run");
  ASSERT_EQ(ending.code, 0) << ending.out << ending.err;
  EXPECT_EQ(ending.err, "");
  EXPECT_NE(ending.out.find("have the digits of the first pull"), std::string::npos) << ending.out;
  const std::string picture = text_of(folder / "run/figures/force_drop.png");
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  EXPECT_EQ(frames("run/drop"), 3u);

  // Every row of the second pull is one of the first one.
  const std::string second = text_of(folder / "run/drop/history.csv");
  EXPECT_TRUE(text_of(folder / "run/history.csv").compare(0, second.size(), second) == 0);
  const json moments = json::parse(text_of(folder / "run/drop/drop.json"));
  const double end = moments["after"]["displacement_m"].get<double>();
  EXPECT_GE(history_rows(folder / "run/drop").back().at("displacement"), end);
  EXPECT_GE(moments["before"]["force_N"].get<double>(), moments["after"]["force_N"].get<double>());
  // The first run is as it was.
  for (const auto& [name, bytes] : first) EXPECT_TRUE(text_of(folder / "run" / name) == bytes);

  // Again: from the frames that are there.
  fs::remove(folder / "run/figures/force_drop.png");
  const Ending again = drop("run");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out.find("is made again"), std::string::npos) << again.out;
  EXPECT_TRUE(fs::exists(folder / "run/figures/force_drop.png"));
  // Another drop needs other frames.
  EXPECT_NE(drop("run --within 0.0015").out.find("is made again"), std::string::npos);
  // A new run takes it all away.
  Words anew = pull_out("run");
  anew.emplace_back("--force");
  summary_of_run(anew);
  EXPECT_FALSE(fs::exists(folder / "run/drop"));
  EXPECT_FALSE(fs::exists(folder / "run/figures/force_drop.png"));
}

TEST_F(DropOfForce, OfARunThatBeganAtThePull)
{
  summary_of_run(pull_out("first"));
  summary_of_run(
      pull_out("run", {"Start from=" + (folder / "first/state_before_pull.h5").string()}));
  ASSERT_FALSE(fs::exists(folder / "run/state_before_pull.h5"));
  const Ending ending = drop("run");
  EXPECT_EQ(ending.code, 0) << ending.out << ending.err;
  EXPECT_TRUE(fs::exists(folder / "run/figures/force_drop.png"));
}

TEST_F(DropOfForce, OfAnotherPullIsNotDrawn)
{
  summary_of_run(pull_out("run"));
  // The last digit of the time of the fourth row.
  std::string text = text_of(folder / "run/history.csv");
  std::size_t line = 0;
  for (int k = 0; k < 4; ++k) line = text.find('\n', line) + 1;
  char& digit = text[text.find(',', line) - 1];
  digit = digit == '1' ? '2' : '1';
  std::ofstream(folder / "run/history.csv") << text;
  const Ending ending = drop("run");
  expect_sentence(ending, 3, {"the second pull is not the first one", "row 4 of history.csv"});
  EXPECT_FALSE(fs::exists(folder / "run/drop/drop.json"));
  EXPECT_FALSE(fs::exists(folder / "run/figures/force_drop.png"));
}
