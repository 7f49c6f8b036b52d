// The program itself, from a parameter file to the end of the run: tiny cases beside this file,
// with few and soft stones. It takes another exit code than 0, a file or a stage that is missing, a
// ledger that does not close (its sum is made here from the single entries), stones that are
// counted wrong, a force, a density or a heap that no such stones can have, or a run that used.prm
// does not repeat to the last digit, to fail.
#include "tests/run_case.h"
#include "tests/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

#include <sys/wait.h>

namespace fs = std::filesystem;
using nlohmann::json;

namespace
{
constexpr double gravity = 9.81;

std::string text_of(const fs::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// The columns of a table by their name without unit; words count as 0.
std::map<std::string, std::vector<double>> table(const fs::path& file)
{
  std::ifstream in(file);
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  std::string line, cell;
  std::getline(in, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');)
    names.push_back(cell.substr(0, cell.find(" [")));
  while (std::getline(in, line)) {
    std::size_t column = 0;
    for (std::istringstream cells(line); std::getline(cells, cell, ','); ++column)
      columns[names.at(column)].push_back(std::strtod(cell.c_str(), nullptr));
    EXPECT_EQ(column, names.size()) << line;
  }
  return columns;
}

class WholeRun : public TemporaryFolderTest
{
protected:
  // Runs the program in the test's folder and returns its summary.
  json run(const std::string& prm, const std::string& output, const std::string& options = "") const
  {
    const std::string command = "cd '" + folder.string() + "' && '" INTERLOCK_PROGRAM "' run '" +
                                prm + "' " + options + " --output '" + output + "' >" + output +
                                ".out 2>" + output + ".err";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << text_of(folder / (output + ".err"));
    EXPECT_EQ(text_of(folder / (output + ".err")), "");
    EXPECT_NE(text_of(folder / output / "run.log").find("Done: "), std::string::npos);
    // What it takes, then the run, then its numbers, then what to do with them.
    const std::string said = text_of(folder / (output + ".out"));
    EXPECT_EQ(said.find("About "), 0u) << said;
    const bool has_page = fs::exists(folder / output / "report.html");
    const std::string next = has_page ? "Look at it in a browser: " : "Numbers for a script: ";
    EXPECT_NE(said.find(next), std::string::npos) << said;
    EXPECT_LT(said.find("Done: "), said.find(next)) << said;
    EXPECT_LE(std::count(said.begin() + said.find("Done: "), said.end(), '\n'), 24) << said;
    for (const auto& entry : fs::directory_iterator(folder / output)) {
      EXPECT_NE(entry.path().extension(), ".part") << entry.path();
      EXPECT_TRUE(entry.is_directory() || entry.file_size() > 0) << entry.path();
    }
    return json::parse(text_of(folder / output / "summary.json"));
  }

  void expect_files(const std::string& output, const std::vector<std::string>& names) const
  {
    for (const std::string& name : names)
      EXPECT_TRUE(fs::is_regular_file(folder / output / name)) << name;
  }
};

std::string tiny(const std::string& name)
{
  return INTERLOCK_SOURCE_DIR "/tests/regression/tiny_" + name + ".prm";
}

std::vector<std::string> stages_of(const json& summary)
{
  std::vector<std::string> names;
  std::int64_t steps = 0;
  for (const json& stage : summary["stages"]) {
    names.push_back(stage["name"]);
    steps += stage["steps"].get<std::int64_t>();
  }
  EXPECT_EQ(steps, summary["steps"]);
  return names;
}

void expect_closed_ledger(const json& summary)
{
  const json& e = summary["energy"];
  const auto sum = [&e](const std::vector<std::string>& names) {
    double total = 0;
    for (const std::string& name : names) {
      EXPECT_TRUE(std::isfinite(e.at(name + "_J").get<double>())) << name;
      total += e[name + "_J"].get<double>();
    }
    return total;
  };
  const double stored = sum({"kinetic_stones", "kinetic_geogrid", "gravitational",
                             "elastic_contacts", "elastic_geogrid"});
  const double lost = sum({"friction", "contact_damping", "local_damping", "geogrid_damping"});
  const double put_in = sum({"clamp_work", "wall_work", "inserted"});
  const double work = e["work_put_in_J"];
  EXPECT_GT(work, 0);
  EXPECT_NEAR(stored + lost, put_in, 0.01 * work);
  EXPECT_GT(e["friction_J"].get<double>(), 0);
  EXPECT_GT(e["contact_damping_J"].get<double>(), 0);
  EXPECT_LT(e["relative_error"].get<double>(), 0.01);
}

// 16 hexadecimal digits, and not those of nothing at all.
void expect_hash(const json& summary)
{
  const std::string hash = summary["state_hash"];
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos) << hash;
  EXPECT_NE(hash, "cbf29ce484222325");
  EXPECT_NE(hash, "0000000000000000");
}
} // namespace

TEST_F(WholeRun, PullOut)
{
  const json s = run(tiny("pull_out"), "run", "--set Output/Report=false");
  EXPECT_EQ(s["experiment"], "pull-out");
  EXPECT_EQ(stages_of(s), (std::vector<std::string>{"stones", "fill lower half", "place geogrid",
                                                    "fill upper half", "settle", "pull"}));
  expect_hash(s);
  expect_closed_ledger(s);
  EXPECT_EQ(warnings_beside_clumps(s["warnings"]), std::vector<std::string>());
  expect_files("run", {"history.csv", "used.prm", "clumps.h5", "clumps.xdmf", "contacts.h5",
                       "contacts.xdmf", "geogrid.h5", "geogrid.xdmf"});

  const json& r = s["results"];
  ASSERT_EQ(r["stones_lost_through_slot"], 0);
  EXPECT_EQ(r["stones"], s["clumps"]);
  // Angular stones, poured: a third to a half of the space is void, less where the mean surface
  // runs through the voids at the walls.
  EXPECT_GT(r["bulk_density_kg_per_m3"], 0.5 * 2650);
  EXPECT_LT(r["bulk_density_kg_per_m3"], 0.8 * 2650);
  EXPECT_NEAR(r["bulk_density_kg_per_m3"].get<double>() * 0.14 * 0.12 *
                  r["mean_surface_height_m"].get<double>(),
              r["mass_in_box_kg"].get<double>(), 1e-9);
  // At least the friction of the ribs' own surface under the weight above, at most that of the
  // whole plane of the geogrid sheared on both sides at 60 degrees.
  const double weight = gravity * r["mass_above_geogrid_kg"].get<double>();
  const double rib_area = 5e-3 * (2 * 0.13 + 2 * 0.06), plan_area = 0.14 * 0.12;
  EXPECT_GT(r["pull_force_at_end_N"], 2 * 0.6 * weight * rib_area / plan_area);
  EXPECT_LT(r["peak_pull_force_N"], 2 * std::tan(M_PI / 3) * weight);
  EXPECT_GE(r["peak_pull_force_N"], r["pull_force_at_end_N"]);

  auto history = table(folder / "run" / "history.csv");
  const std::vector<double>&x = history.at("displacement"), &force = history.at("pull_force");
  ASSERT_EQ(x.size(), 31u); // one more than the records: the start
  EXPECT_EQ(x.front(), 0);
  EXPECT_NEAR(x.back(), 3e-3, 1e-5);
  for (std::size_t k = 1; k < x.size(); ++k) EXPECT_NEAR(x[k] - x[k - 1], 1e-4, 1e-5) << k;
  // The recorded force over its way is the work of the clamp, for the geogrid moves little else.
  double work = 0;
  for (std::size_t k = 1; k < x.size(); ++k) work += force[k] * (x[k] - x[k - 1]);
  const double clamp_work = s["energy"]["pull_clamp_work_J"];
  EXPECT_NEAR(work, clamp_work, 0.03 * clamp_work);
  EXPECT_LT(s["energy"]["pull_relative_error"].get<double>(), 0.01);
}

// With spheres as a surcharge, which are no stones; and the figure that the report promises.
TEST_F(WholeRun, PullOutWithSurchargeAndFigures)
{
  const json s = run(tiny("pull_out"), "run",
                     "--set Surcharge/Force=20 --set \"Surcharge/Sphere radius=0.025\""
                     " --set \"Geogrid/Placement=flattened\" --set Pull/Distance=0.001");
  expect_hash(s);
  expect_closed_ledger(s);
  EXPECT_EQ(stages_of(s),
            (std::vector<std::string>{"stones", "fill lower half", "flatten", "place geogrid",
                                      "fill upper half", "surcharge", "settle", "pull"}));
  ASSERT_EQ(s["results"]["stones_lost_through_slot"], 0);
  EXPECT_EQ(s["results"]["surcharge_N"], 20);
  const int spheres = 2 * 2; // of 50 mm in 140 mm x 120 mm
  EXPECT_EQ(s["results"]["stones"].get<int>() + spheres, s["clumps"].get<int>());
  EXPECT_TRUE(fs::is_regular_file(folder / "run" / "figures" / "force_displacement.png"));
}

TEST_F(WholeRun, HeapTwiceWithTheSameDigits)
{
  const json s = run(tiny("heap"), "run");
  EXPECT_EQ(s["experiment"], "heap");
  EXPECT_EQ(stages_of(s), (std::vector<std::string>{"stones", "drop", "settle"}));
  EXPECT_EQ(s["clumps"], 10);
  expect_hash(s);
  expect_closed_ledger(s);
  EXPECT_EQ(warnings_beside_clumps(s["warnings"]), std::vector<std::string>());
  expect_files(
      "run", {"history.csv", "used.prm", "stones.csv", "profile.csv", "clumps.h5", "clumps.xdmf"});

  // All that was put in is the fall of the stones: from 0.15 m to where they rest.
  const json& r = s["results"];
  auto stones = table(folder / "run" / "stones.csv");
  ASSERT_EQ(stones.at("mass").size(), 10u);
  double mass = 0, fall = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    mass += stones["mass"][k];
    fall += gravity * stones["mass"][k] * (0.15 - stones.at("z")[k]);
    EXPECT_GT(stones["z"][k], 0.005) << k; // no stone is in the floor, and none flew off
    EXPECT_LT(stones["z"][k], 0.1) << k;
    EXPECT_LT(std::hypot(stones.at("x")[k], stones.at("y")[k]), 0.3) << k;
  }
  EXPECT_NEAR(mass, r["mass_kg"].get<double>(), 1e-5 * mass);
  EXPECT_NEAR(s["energy"]["work_put_in_J"].get<double>(), fall, 0.02 * fall);
  const double lost = s["energy"]["friction_J"].get<double>() +
                      s["energy"]["contact_damping_J"].get<double>() +
                      s["energy"]["local_damping_J"].get<double>();
  EXPECT_NEAR(lost, fall, 0.02 * fall);
  EXPECT_LT(r["largest_overlap_over_mean_sphere_radius"], 0.1);
  EXPECT_EQ(r["stones_lost_over_the_edge"], 0);

  const json again = run("run/used.prm", "again");
  EXPECT_EQ(again["state_hash"], s["state_hash"]);
  EXPECT_EQ(again["steps"], s["steps"]);
  const json other = run(tiny("heap"), "other", "--set Drop/Seed=2");
  EXPECT_EQ(other["clumps"], 10);
  EXPECT_GT(std::abs(other["results"]["radius_of_gyration_m"].get<double>() -
                     r["radius_of_gyration_m"].get<double>()),
            1e-6);
}
