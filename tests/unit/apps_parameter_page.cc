// The page of all parameters. It takes an entry that the page lacks, or a page in docs/ that is not
// that of the program, to fail.
#include "apps/parameter_page.h"

#include "apps/experiments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace interlock;

namespace
{
const apps::ParameterLine& line_of(const std::vector<apps::ParameterLine>& lines,
                                   const std::string& key, const std::string& experiment)
{
  return *std::find_if(lines.begin(), lines.end(), [&](const apps::ParameterLine& line) {
    return line.key == key &&
           std::count(line.experiments.begin(), line.experiments.end(), experiment) == 1;
  });
}
} // namespace

TEST(ParameterPage, HasEveryEntryOfEveryExperimentOnce)
{
  const auto lines = apps::parameter_lines();
  for (const apps::Experiment& experiment : apps::experiments()) {
    coupling::ParameterTable table;
    apps::ExperimentParameters parameters = experiment.defaults;
    experiment.declare(table, parameters);
    for (const coupling::ParameterEntry& entry : table.entries())
      EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                              [&](const apps::ParameterLine& line) {
                                return line.key == entry.key() &&
                                       std::count(line.experiments.begin(), line.experiments.end(),
                                                  experiment.name) == 1;
                              }),
                1)
          << entry.key() << " of " << experiment.name;
  }
}

TEST(ParameterPage, SaysUnitRangeAndDefault)
{
  const auto speed = line_of(apps::parameter_lines(), "Pull/Speed", "pull-out");
  EXPECT_EQ(speed.unit, "m/s");
  EXPECT_EQ(speed.allowed, "a number greater than 0");
  EXPECT_FALSE(speed.usual.empty());
  EXPECT_EQ(speed.start, "to be given");
}

TEST(ParameterPage, FindsEntriesByAWord)
{
  const auto lines = apps::lines_about("SPEED");
  EXPECT_GT(lines.size(), 2u);
  EXPECT_LT(lines.size(), apps::parameter_lines().size());
  EXPECT_TRUE(apps::lines_about("no such word").empty());
}

TEST(ParameterPage, InTheDocumentsIsThatOfTheProgram)
{
  std::ifstream file(INTERLOCK_SOURCE_DIR "/docs/parameters.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(page == apps::parameter_page())
      << "Make it anew: build/release/bin/interlock parameters --page > docs/parameters.md";
}
