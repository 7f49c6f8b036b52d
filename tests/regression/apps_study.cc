// Whole studies through the program. Fails when two equal cases from one packed state differ in a
// digit, when a run that fails ends the others or the exit code is 0, when runs of another study
// are taken for those of this one, when a finished run is made again, or when the split of the
// variance is not that of a function which is known.
#include "tests/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <sys/wait.h>

namespace fs = std::filesystem;

namespace
{
const std::string sources = INTERLOCK_SOURCE_DIR;
using Row = std::map<std::string, std::string>;

class Study : public TemporaryFolderTest
{
protected:
  void run(const fs::path& study, const std::string& options)
  {
    const std::string command = "cd '" + folder.string() + "' && '" INTERLOCK_PROGRAM "' study '" +
                                study.string() + "' " + options + " >out 2>err";
    const int status = std::system(command.c_str());
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    out = file_text(folder / "out");
    err = file_text(folder / "err");
  }

  // Rows of a table whose quoted cells hold no line breaks.
  std::vector<Row> table(const std::string& name) const
  {
    std::ifstream in(folder / name);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> heads = cells(line);
    std::vector<Row> rows;
    while (std::getline(in, line)) {
      const std::vector<std::string> values = cells(line);
      EXPECT_EQ(values.size(), heads.size()) << line;
      rows.emplace_back();
      for (std::size_t c = 0; c < std::min(heads.size(), values.size()); ++c)
        rows.back()[heads[c]] = values[c];
    }
    return rows;
  }

  static std::vector<std::string> cells(const std::string& line)
  {
    std::vector<std::string> result(1);
    bool quoted = false;
    for (const char c : line)
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        result.emplace_back();
      else
        result.back() += c;
    return result;
  }

  int code = -1;
  std::string out, err;
};
} // namespace

TEST_F(Study, EqualCasesFailingRunsAndForeignOnes)
{
  const std::string text = "set Base case = " + sources +
                           "/tests/regression/tiny_pull_out.prm\n"
                           "set Start from = packed\nset Fillings = 1\n"
                           "subsection Measures\n  set Forces at = 0.001, 0.002\nend\n"
                           "subsection Fixed\n  set Output/Field frames = 0\nend\n"
                           "subsection Parameters\n"
                           "  set ribs = as in the case:, breaking: Geogrid/Break strain=1e-5, "
                           "the same: Geogrid/Youngs modulus=2.4e9\nend\n";
  const fs::path study = write("study.prm", text);
  run(study, "--check -o made");
  EXPECT_EQ(code, 0) << err;
  EXPECT_NE(out.find("3 runs: 3 points, 1 fillings; they start from 1 states"), std::string::npos)
      << out;
  EXPECT_NE(out.find("processor time"), std::string::npos) << out;
  EXPECT_FALSE(fs::exists(folder / "made"));

  run(study, "--jobs 2 -o made");
  EXPECT_EQ(code, 3) << out << err;
  EXPECT_NE(err.find("1 of 3 runs of the study are missing"), std::string::npos) << err;
  const auto rows = table("made/runs.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].at("status"), "done");
  EXPECT_EQ(rows[1].at("status"), "failed");
  EXPECT_NE(rows[1].at("reason").find("A rib breaks"), std::string::npos) << rows[1].at("reason");
  EXPECT_EQ(rows[1].at("peak_force_N"), "");
  EXPECT_NE(out.find(rows[1].at("reason")), std::string::npos) << out;
  EXPECT_EQ(rows[2].at("status"), "done");
  EXPECT_EQ(rows[2].at("state_hash"), rows[0].at("state_hash"));
  EXPECT_GT(std::stod(rows[0].at("peak_force_N")), 0);
  // What resists the pull adds up to it.
  double shares = std::stod(rows[0].at("load_share_longitudinal_ribs"));
  for (const char* rib : {"0", "1", "2"})
    shares += std::stod(rows[0].at(std::string("load_share_transverse_rib_") + rib));
  EXPECT_NEAR(shares, 1, 1e-12);

  int differences = 0;
  for (const Row& row : table("made/differences.csv")) {
    if (row.at("level") != "the same") continue;
    ++differences;
    EXPECT_EQ(row.at("mean_difference"), "0") << row.at("measure");
    EXPECT_EQ(row.at("n"), "1") << row.at("measure");
  }
  EXPECT_GT(differences, 20);

  // What is over stays; what failed is tried again.
  const auto before =
      fs::last_write_time(folder / "made/runs/ribs-the-same_filling-1/summary.json");
  const std::string csv = file_text(folder / "made/runs.csv");
  run(study, "-o made");
  EXPECT_EQ(code, 3);
  EXPECT_NE(out.find("3 of 4 are there already"), std::string::npos) << out;
  EXPECT_EQ(fs::last_write_time(folder / "made/runs/ribs-the-same_filling-1/summary.json"), before);
  EXPECT_EQ(file_text(folder / "made/runs.csv"), csv);

  // Another speed: those runs are of another study.
  std::string other = text;
  other.replace(other.find("end\nsubsection Parameters"), 4, "  set Pull/Speed = 0.2\nend\n");
  run(write("other.prm", other), "-o made");
  EXPECT_EQ(code, 2) << out;
  for (const char* fact : {"\"Pull/Speed\"", "\"0.1\" there", "\"0.2\" now", "--force"})
    EXPECT_NE(err.find(fact), std::string::npos) << err;
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  EXPECT_EQ(file_text(folder / "made/runs.csv"), csv);
}

// The stretch is c F/E: f = x y with x = 1, 2, 3 and y = 1, 1/2, so the parts of the variance are
// mean(y)^2 var(x), mean(x)^2 var(y) and var(x) var(y): 9, 6 and 1 sixteenths.
TEST_F(Study, KnownSplitOfTheVariance)
{
  run(sources + "/tests/regression/study_of_a_product.prm", "-o product");
  EXPECT_EQ(code, 0) << err;
  std::map<std::string, double> shares;
  for (const Row& row : table("product/variance.csv"))
    if (row.at("measure") == "largest_displacement_m")
      shares[row.at("term")] = std::stod(row.at("share"));
  EXPECT_NEAR(shares["force"], 9. / 16, 1e-6);
  EXPECT_NEAR(shares["modulus"], 6. / 16, 1e-6);
  EXPECT_NEAR(shares["force x modulus"], 1. / 16, 1e-6);
  EXPECT_NEAR(shares["all of several"], 1. / 16, 1e-6); // of set-up and geogrid
}
