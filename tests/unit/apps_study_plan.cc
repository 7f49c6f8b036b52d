// From a study file to its runs: levels and ranges, the four designs, names, and which packed state
// each run starts from.
#include "apps/study/plan.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <set>

namespace apps = interlock::apps;
namespace fs = std::filesystem;

namespace
{
const std::string base =
    "set Base case = " INTERLOCK_SOURCE_DIR "/tests/regression/tiny_pull_out.prm\n";

class StudyPlan : public TemporaryFolderTest
{
protected:
  apps::StudyFile read(const std::string& text)
  {
    return apps::read_study_file(write("study.prm", base + text));
  }
  apps::Plan plan(const std::string& text) { return apps::make_plan(read(text), folder / "out"); }

  static std::vector<std::string> names(const apps::Plan& plan)
  {
    std::vector<std::string> result;
    for (const apps::Task& task : plan.tasks) result.push_back(task.folder.string());
    return result;
  }
  static std::string value(const apps::RunInput& input, const std::string& key)
  {
    for (const auto& entry : input.entries)
      if (entry.key == key) return entry.value;
    return "no such entry";
  }
};
} // namespace

TEST_F(StudyPlan, LevelsAndRanges)
{
  const apps::StudyFile study =
      read("subsection Parameters\n"
           "  set Contact/Stone friction = 0.4, 0.6\n"
           "  set Geogrid/Youngs modulus = 1e8 to 1e10 in 3 log\n"
           "  set Pull/Speed = 0.1 to 0.2\n"
           "  set ribs = rigid: Geogrid/Rigid=true, soft: Geogrid/Rigid=false & "
           "Geogrid/Density=1000, plain:\n"
           "end\n");
  ASSERT_EQ(study.factors.size(), 4u);
  EXPECT_EQ(study.factors[0].levels[1].name, "0.6");
  EXPECT_EQ(study.factors[0].kind(), apps::FactorKind::set_up);
  EXPECT_EQ(study.factors[1].levels[1].name, "1e+09");
  EXPECT_EQ(study.factors[1].at(0.25).name, "3.16228e+08");
  EXPECT_EQ(study.factors[1].kind(), apps::FactorKind::geogrid);
  EXPECT_EQ(study.factors[2].levels.size(), 2u);
  EXPECT_EQ(study.factors[2].at(0.5).entries[0].value, "0.15");
  ASSERT_EQ(study.factors[3].levels.size(), 3u);
  EXPECT_EQ(study.factors[3].levels[1].entries[1].key(), "Geogrid/Density");
  EXPECT_EQ(study.factors[3].levels[1].entries[1].value, "1000");
  EXPECT_TRUE(study.factors[3].levels[2].entries.empty());
  EXPECT_EQ(study.factors[3].kind(), apps::FactorKind::geogrid);
  // What is not said.
  EXPECT_EQ(study.measures.forces_at, (std::vector<double>{0.002, 0.005, 0.01, 0.02}));
  EXPECT_EQ(study.fillings.levels.size(), 1u);
}

// Another product lies between other stones.
TEST_F(StudyPlan, ProductsGetStatesOfTheirOwn)
{
  const std::string products = INTERLOCK_SOURCE_DIR "/cases/geogrids/";
  const apps::Plan made = apps::make_plan(
      apps::read_study_file(write("study.prm", "set Base case = " INTERLOCK_SOURCE_DIR
                                               "/cases/pullout/quick.prm\nset Start from = packed\n"
                                               "subsection Parameters\n  set Geogrid/Product = " +
                                                   products + "ssla30.prm, " + products +
                                                   "assumed_5x2.5.prm\nend\n")),
      folder / "out");
  EXPECT_EQ(made.n_states, 2);
}

TEST_F(StudyPlan, GridOfTwoFactorsAndFillings)
{
  const apps::Plan made =
      plan("set Fillings = 1, 2\nsubsection Parameters\n"
           "  set Geogrid/Rigid = true, false\n  set Pull/Speed = 0.1, 0.2\nend\n");
  EXPECT_EQ(made.n_states, 0);
  ASSERT_EQ(made.tasks.size(), 8u);
  EXPECT_EQ(made.tasks[0].folder, "runs/Rigid-true_Speed-0.1_filling-1");
  EXPECT_EQ(made.tasks[1].folder, "runs/Rigid-true_Speed-0.1_filling-2");
  EXPECT_EQ(made.tasks[2].folder, "runs/Rigid-true_Speed-0.2_filling-1");
  EXPECT_EQ(made.tasks[7].folder, "runs/Rigid-false_Speed-0.2_filling-2");
  const apps::RunInput input = apps::read_task(made, made.tasks[7]);
  EXPECT_EQ(value(input, "Pull/Speed"), "0.2");
  EXPECT_EQ(value(input, "Filling/Seed"), "2");
  EXPECT_EQ(value(input, "Output/Report"), "false"); // unless it is asked for
}

TEST_F(StudyPlan, OneLevelMoreLeavesTheOtherNames)
{
  const auto few = names(plan("subsection Parameters\n  set Pull/Speed = 0.1, 0.2\nend\n")),
             more = names(plan("set Fillings = 1, 3\nset Filling entry = Filling/Seed\n"
                               "subsection Parameters\n  set Pull/Speed = 0.05, 0.1, 0.2\nend\n"));
  EXPECT_EQ(few[0], "runs/Speed-0.1_filling-base");
  EXPECT_EQ(std::count(more.begin(), more.end(), "runs/Speed-0.2_filling-3"), 1);
}

TEST_F(StudyPlan, OneAtATimeStartsFromTheFirstLevels)
{
  const auto made =
      names(plan("set Design = one at a time\nsubsection Parameters\n"
                 "  set Geogrid/Rigid = false, true\n  set Pull/Speed = 0.1, 0.2, 0.3\nend\n"));
  EXPECT_EQ(made, (std::vector<std::string>{"runs/Rigid-false_Speed-0.1_filling-base",
                                            "runs/Rigid-true_Speed-0.1_filling-base",
                                            "runs/Rigid-false_Speed-0.2_filling-base",
                                            "runs/Rigid-false_Speed-0.3_filling-base"}));
}

// Each of the strata of each column holds one point; the same seed gives the same points.
TEST_F(StudyPlan, HypercubeIsStratifiedAndRepeatable)
{
  constexpr int samples = 50;
  const auto rows = apps::latin_hypercube(samples, 3, 7);
  for (int column = 0; column < 3; ++column) {
    std::set<int> strata;
    for (const auto& row : rows) {
      ASSERT_GE(row[column], 0);
      ASSERT_LT(row[column], 1);
      strata.insert(static_cast<int>(row[column] * samples));
    }
    EXPECT_EQ(strata.size(), 50u);
  }
  EXPECT_EQ(rows, apps::latin_hypercube(samples, 3, 7));
  EXPECT_NE(rows, apps::latin_hypercube(samples, 3, 8));
  EXPECT_NE(rows[0][0], rows[0][1]);

  const apps::Plan made =
      plan("set Design = latin hypercube\nset Samples = 4\nset Fillings = 1, 2\n"
           "subsection Parameters\n  set Pull/Speed = 0.1 to 0.2\n"
           "  set Geogrid/Rigid = true, false\nend\n");
  ASSERT_EQ(made.tasks.size(), 8u);
  EXPECT_EQ(made.tasks[3].folder, "runs/point-2_filling-2");
  int rigid = 0;
  for (const apps::Point& point : made.points) rigid += point.levels[1].name == "true" ? 1 : 0;
  EXPECT_EQ(rigid, 2); // half of four strata
}

// A, B, and A with one column of B each, the filling the last one.
TEST_F(StudyPlan, SobolsMatrices)
{
  const apps::Plan made = plan("set Design = sobol\nset Samples = 3\nset Fillings = 1, 2, 3\n"
                               "subsection Parameters\n  set Pull/Speed = 0.1 to 0.2\n"
                               "  set Contact/Stone friction = 0.4 to 0.8\nend\n");
  ASSERT_EQ(made.points.size(), 3u * 5);
  ASSERT_EQ(made.tasks.size(), 3u * 5);
  const apps::Point *a = made.points.data(), *b = a + 1;
  EXPECT_EQ(a[2].levels[0].name, b->levels[0].name);
  EXPECT_EQ(a[2].levels[1].name, a->levels[1].name);
  EXPECT_EQ(a[2].filling, a->filling);
  EXPECT_EQ(a[3].levels[0].name, a->levels[0].name);
  EXPECT_EQ(a[3].levels[1].name, b->levels[1].name);
  EXPECT_EQ(a[4].levels[1].name, a->levels[1].name);
  EXPECT_EQ(a[4].filling, b->filling);
}

// What the state has fixed makes a state of its own, all else starts from the same one.
TEST_F(StudyPlan, RunsShareStates)
{
  const apps::Plan made =
      plan("set Fillings = 1, 2\nset Start from = packed\nsubsection Parameters\n"
           "  set Geogrid/Pitch along = 0.065, 0.06\n"
           "  set Geogrid/Youngs modulus = 1e9, 2e9\nend\n");
  EXPECT_EQ(made.n_states, 4);
  ASSERT_EQ(made.tasks.size(), 4u + 8);
  EXPECT_EQ(made.tasks[0].folder, "states/Pitch-along-0.065_filling-1");
  const auto state_of = [&](int task) { return made.tasks[made.tasks[task].state].name; };
  EXPECT_EQ(state_of(4), "Pitch-along-0.065_filling-1"); // moduli of 1 and 2 GPa
  EXPECT_EQ(state_of(6), "Pitch-along-0.065_filling-1");
  EXPECT_EQ(state_of(11), "Pitch-along-0.06_filling-2");
  const apps::RunInput input = apps::read_task(made, made.tasks[11]);
  EXPECT_EQ(value(input, "Start from"),
            (folder / "out/states/Pitch-along-0.06_filling-2/state_before_pull.h5").string());
  // The state before the geogrid has fixed no pitch.
  EXPECT_EQ(plan("set Start from = placed\nsubsection Parameters\n"
                 "  set Geogrid/Pitch along = 0.065, 0.06\nend\n")
                .n_states,
            1);
  // Levels that agree in what is fixed share, whatever their names; so does the value of the case.
  EXPECT_EQ(plan("set Start from = packed\nsubsection Parameters\n"
                 "  set ribs = a: Geogrid/Pitch along=0.065 & Geogrid/Youngs modulus=1e9, "
                 "b: Geogrid/Pitch along=0.065, c:, d: Geogrid/Pitch along=0.06\nend\n")
                .n_states,
            2);
  // Friction may change after the filling; if it is to act in it, the study says so.
  const std::string friction =
      "subsection Parameters\n  set Contact/Stone friction = 0.5, 0.6\nend\n";
  EXPECT_EQ(plan("set Start from = packed\n" + friction).n_states, 1);
  EXPECT_EQ(
      plan("set Start from = packed\nset Refilled = Contact/Stone friction\n" + friction).n_states,
      2);
}
