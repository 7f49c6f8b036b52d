// Runs that start from the state that another one has left behind, through the program itself.
// Fails when the same entries give another digit, when another pull begins with another packing, or
// when a state that does not fit the case is taken for good.
#include "tests/run_case.h"
#include "tests/stopped_run.h"

using namespace stopped_run;

namespace
{
class StartFrom : public StoppedRunTest
{
};

Words stages_of(const json& summary)
{
  Words names;
  for (const json& stage : summary["stages"]) names.push_back(stage["name"]);
  return names;
}

std::vector<double> column(const fs::path& file, const std::string& name)
{
  std::ifstream in(file);
  std::string line, cell;
  std::getline(in, line);
  std::size_t place = 0;
  std::istringstream head(line);
  while (std::getline(head, cell, ',') && cell.substr(0, cell.find(" [")) != name) ++place;
  std::vector<double> values;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (std::size_t k = 0; k <= place; ++k) std::getline(cells, cell, ',');
    values.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return values;
}
} // namespace

TEST_F(StartFrom, TheStateBeforeThePullRepeatsThePull)
{
  const json first = summary_of_run(pull_out("first"));
  const json again = summary_of_run(
      pull_out("again", {"Start from=" + (folder / "first/state_before_pull.h5").string()}));
  EXPECT_EQ(stages_of(again), (Words{"start", "pull"}));
  EXPECT_EQ(again["state_hash"], first["state_hash"]);
  EXPECT_EQ(column(folder / "again/history.csv", "pull_force"),
            column(folder / "first/history.csv", "pull_force"));
  EXPECT_TRUE(text_of(folder / "again/history.csv") == text_of(folder / "first/history.csv"));
  EXPECT_EQ(again["results"], first["results"]);
  // The state that it started from was only read.
  EXPECT_FALSE(fs::exists(folder / "first/state_before_pull.h5.part"));
  // It can be stopped and resumed like any other.
  const Words words =
      pull_out("run", {"Start from=" + (folder / "first/state_before_pull.h5").string()});
  ASSERT_EQ(stop(SIGKILL, words, when_rows("run", 10)).code, -SIGKILL);
  summary_of_run(resumed(words));
  expect_same_run("again", "run");
}

// Only the pull is another one: it begins at once, with the packing of the first run.
TEST_F(StartFrom, TheStateBeforeThePullWithAnotherPull)
{
  const json first = summary_of_run(pull_out("first"));
  const json faster = summary_of_run(
      pull_out("faster", {"Start from=" + (folder / "first/state_before_pull.h5").string(),
                          "Pull/Speed=0.2", "Pull/Ramp time=0.002"}));
  EXPECT_EQ(stages_of(faster), (Words{"start", "pull"}));
  for (const char* name : {"mass_in_box_kg", "mean_surface_height_m", "bulk_density_kg_per_m3"})
    EXPECT_EQ(faster["results"][name], first["results"][name]) << name;
  EXPECT_NE(faster["state_hash"], first["state_hash"]);
  EXPECT_LT(faster["energy"]["relative_error"].get<double>(), 0.01);
}

// Softer ribs around the same stones: they settle anew, and twice alike.
TEST_F(StartFrom, TheStateBeforeThePullWithAnotherModulus)
{
  const json first = summary_of_run(pull_out("first"));
  const Words entries = {"Start from=" + (folder / "first/state_before_pull.h5").string(),
                         "Geogrid/Youngs modulus=1.2e9"};
  const json one = summary_of_run(pull_out("one", entries)),
             two = summary_of_run(pull_out("two", entries));
  EXPECT_EQ(stages_of(one), (Words{"start", "adapt", "settle", "pull"}));
  EXPECT_EQ(one["state_hash"], two["state_hash"]);
  expect_same_run("one", "two");
  EXPECT_NE(one["state_hash"], first["state_hash"]);
  EXPECT_EQ(one["clumps"], first["clumps"]);
  EXPECT_EQ(warnings_beside_clumps(one["warnings"]), std::vector<std::string>());
  EXPECT_LT(one["energy"]["relative_error"].get<double>(), 0.01);
  // Another geogrid stiffness must not move the stones far before the pull.
  EXPECT_NEAR(one["results"]["mean_surface_height_m"].get<double>(),
              first["results"]["mean_surface_height_m"].get<double>(), 1e-3);
}

TEST_F(StartFrom, TheStateBeforeThePullWithASurcharge)
{
  summary_of_run(pull_out("first"));
  const json loaded = summary_of_run(
      pull_out("loaded", {"Start from=" + (folder / "first/state_before_pull.h5").string(),
                          "Surcharge/Force=20", "Surcharge/Sphere radius=0.025"}));
  EXPECT_EQ(stages_of(loaded), (Words{"start", "adapt", "surcharge", "settle", "pull"}));
  EXPECT_EQ(loaded["results"]["surcharge_N"], 20);
  EXPECT_LT(loaded["energy"]["relative_error"].get<double>(), 0.01);
}

TEST_F(StartFrom, TheStateBeforeTheGeogridWithAnotherPitch)
{
  const json first = summary_of_run(pull_out("first"));
  const std::string state = (folder / "first/state_before_geogrid.h5").string();
  const json same = summary_of_run(pull_out("same", {"Start from=" + state}));
  EXPECT_EQ(stages_of(same),
            (Words{"start", "place geogrid", "fill upper half", "settle", "pull"}));
  EXPECT_EQ(same["state_hash"], first["state_hash"]);
  EXPECT_TRUE(text_of(folder / "same/history.csv") == text_of(folder / "first/history.csv"));
  const json other =
      summary_of_run(pull_out("other", {"Start from=" + state, "Geogrid/Pitch along=0.06"}));
  EXPECT_EQ(stages_of(other), stages_of(same));
  EXPECT_NE(other["state_hash"], first["state_hash"]);
  EXPECT_LT(other["energy"]["relative_error"].get<double>(), 0.01);
}

// What the state has fixed, and files that are no such state. Nothing is written.
TEST_F(StartFrom, WhatDoesNotFitIsRefused)
{
  summary_of_run(pull_out("first"));
  const std::string before_pull = (folder / "first/state_before_pull.h5").string(),
                    before_geogrid = (folder / "first/state_before_geogrid.h5").string();
  const auto refused = [&](const Words& entries, const Words& facts) {
    expect_sentence(run(pull_out("refused", entries)), 2, facts);
    EXPECT_FALSE(fs::exists(folder / "refused"));
  };
  refused({"Start from=" + before_pull, "Filling/Seed=2"},
          {before_pull, "Filling/Seed", "\"1\"", "\"2\""});
  refused({"Start from=" + before_pull, "Geogrid/Pitch along=0.06"},
          {"Geogrid/Pitch along", "0.065", "0.06"});
  refused({"Start from=" + before_geogrid, "Stones/Density=2700"}, {"Stones/Density", "2700"});
  refused({"Start from=" + (folder / "first/checkpoint.h5").string()},
          {"checkpoint.h5", "state_before_pull.h5"});
  refused({"Start from=" + (folder / "nothing.h5").string()}, {"nothing.h5"});
  refused({"Start from=" + (folder / "first").string()}, {"first"});
  write("foreign.h5", "a,b\n1,2\n");
  refused({"Start from=" + (folder / "foreign.h5").string()}, {"foreign.h5"});
  write("empty.h5", "");
  refused({"Start from=" + (folder / "empty.h5").string()}, {"empty.h5", "empty"});
  std::string bytes = text_of(before_pull);
  bytes[bytes.size() - 100] ^= 4;
  write("damaged.h5", bytes);
  refused({"Start from=" + (folder / "damaged.h5").string()}, {"damaged.h5", "checksum"});
}

TEST_F(StartFrom, AHeapIsRefused)
{
  summary_of_run({tiny_heap, "--set", "Output/Report=false", "--output", "heap"});
  expect_sentence(
      run(pull_out("refused", {"Start from=" + (folder / "heap/checkpoint.h5").string()})), 2,
      {"checkpoint.h5", "heap", "pull-out"});
  EXPECT_FALSE(fs::exists(folder / "refused"));
}
