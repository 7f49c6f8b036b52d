// Runs that are stopped, killed, resumed, or started from the state of another one, through the
// program itself. It takes one digit of hash, history or frame that differs from the undisturbed
// run, an exit code or a sentence that does not say what happened, a state taken for good that does
// not fit the case, or a refusal that touches the results it refuses, to fail.
#include "tests/run_case.h"
#include "tests/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using nlohmann::json;

namespace
{
using Words = std::vector<std::string>;

const std::string tiny_pull_out = INTERLOCK_SOURCE_DIR "/tests/regression/tiny_pull_out.prm";
const std::string tiny_heap = INTERLOCK_SOURCE_DIR "/tests/regression/tiny_heap.prm";

std::string text_of(const fs::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t lines_of(const fs::path& file)
{
  const std::string text = text_of(file);
  return std::count(text.begin(), text.end(), '\n');
}

// Without what a clock measured, at any depth.
json without_wall_times(const json& value)
{
  if (value.is_array()) {
    json result = json::array();
    for (const json& entry : value) result.push_back(without_wall_times(entry));
    return result;
  }
  if (!value.is_object()) return value;
  json result = json::object();
  for (const auto& [key, entry] : value.items())
    if (key.compare(0, 9, "wall_time") != 0 && key != "origin" && key != "parameters_hash")
      result[key] = without_wall_times(entry);
  return result;
}

Words stages_of(const json& summary)
{
  Words names;
  for (const json& stage : summary["stages"]) names.push_back(stage["name"]);
  return names;
}

// How a process ended and what it said.
struct Ending {
  int code = -1; // exit code, or minus the signal that killed it
  std::string out, err;
};

class Resume : public TemporaryFolderTest
{
protected:
  // Starts "interlock run" in the test's folder.
  pid_t start(const Words& words) const
  {
    Words all = {INTERLOCK_PROGRAM, "run"};
    all.insert(all.end(), words.begin(), words.end());
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const auto redirect = [&](const char* name, int stream) {
      dup2(open((folder / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), stream);
    };
    redirect("out", STDOUT_FILENO);
    redirect("err", STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execv(INTERLOCK_PROGRAM, arguments.data());
    _exit(127);
  }

  Ending end_of(pid_t child) const
  {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), text_of(folder / "out"),
            text_of(folder / "err")};
  }

  Ending run(const Words& words) const { return end_of(start(words)); }

  // Sends the signal as soon as `now` holds. On a busy machine this process may look too late: a
  // run that was over before is started anew.
  Ending stop(int signal, const Words& words, const std::function<bool()>& now) const
  {
    const bool anew = std::find(words.begin(), words.end(), "--resume") == words.end();
    Ending ending;
    for (int attempt = 0; attempt < (anew ? 20 : 1); ++attempt) {
      if (anew) fs::remove_all(folder / output_of(words));
      ending = try_to_stop(signal, words, now);
      if (ending.code != 0) break;
    }
    return ending;
  }

  Ending try_to_stop(int signal, const Words& words, const std::function<bool()>& now) const
  {
    const pid_t child = start(words);
    siginfo_t info{};
    while (!now()) {
      info.si_pid = 0;
      waitid(P_PID, child, &info, WEXITED | WNOHANG | WNOWAIT);
      if (info.si_pid != 0) break; // it was over before: the exit code tells
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    kill(child, signal);
    return end_of(child);
  }

  // To the end; the summary.
  json summary_of_run(const Words& words) const
  {
    const Ending ending = run(words);
    EXPECT_EQ(ending.code, 0) << ending.err;
    return summary(output_of(words));
  }

  json summary(const std::string& output) const
  {
    const std::string text = text_of(folder / output / "summary.json");
    return text.empty() ? json::object() : json::parse(text);
  }

  static std::string output_of(const Words& words)
  {
    for (std::size_t k = 0; k + 1 < words.size(); ++k)
      if (words[k] == "--output") return words[k + 1];
    return {};
  }

  // All that a run leaves for its reader: file name and bytes.
  std::map<std::string, std::string> results(const std::string& output) const
  {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / output)) {
      const fs::path path = entry.path();
      const std::string name = fs::relative(path, folder / output).string();
      EXPECT_NE(path.extension(), ".part") << name;
      const bool kept_state =
          name.compare(0, 10, "checkpoint") == 0 || name.compare(0, 6, "state_") == 0;
      if (entry.is_regular_file() && !kept_state && name != "run.log" && name != "used.prm" &&
          name != "summary.json")
        files[name] = text_of(path);
    }
    return files;
  }

  void expect_same_run(const std::string& one, const std::string& other) const
  {
    const json a = summary(one), b = summary(other);
    EXPECT_EQ(a["state_hash"], b["state_hash"]);
    EXPECT_EQ(without_wall_times(a), without_wall_times(b));
    const auto files = results(one), others = results(other);
    EXPECT_GT(files.count("history.csv"), 0u);
    for (const auto& [name, bytes] : files) {
      const auto found = others.find(name);
      if (found == others.end())
        ADD_FAILURE() << name << " is missing in " << other;
      else
        EXPECT_TRUE(found->second == bytes) << name << " differs";
    }
    for (const auto& file : others)
      EXPECT_GT(files.count(file.first), 0u) << file.first << " is too much in " << other;
  }

  std::function<bool()> when_rows(const std::string& output, std::size_t n) const
  {
    return [=] { return lines_of(folder / output / "history.csv") > n; };
  }

  std::function<bool()> when_logged(const std::string& output, const std::string& text) const
  {
    return [=] { return text_of(folder / output / "run.log").find(text) != std::string::npos; };
  }
};

Words pull_out(const std::string& output, const Words& entries = {})
{
  Words words = {tiny_pull_out, "--set", "Output/Report=false", "--set",
                 "Output/Checkpoint interval=0.2"};
  for (const std::string& entry : entries) words.insert(words.end(), {"--set", entry});
  words.insert(words.end(), {"--output", output});
  return words;
}

Words resumed(Words words)
{
  words.emplace_back("--resume");
  return words;
}

// One line for people, with all of the facts in it.
void expect_sentence(const Ending& ending, int code, const Words& facts)
{
  EXPECT_EQ(ending.code, code) << ending.out << ending.err;
  EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
  EXPECT_NE(ending.err.find(".\n"), std::string::npos) << ending.err;
  for (const std::string& fact : facts)
    EXPECT_NE(ending.err.find(fact), std::string::npos) << fact << " is not in: " << ending.err;
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

// The line that the run leaves is typed as it stands, for a file with a blank in its name.
// Stopped where the second stage begins and in the pull. While the first stones are placed there is
// no state to keep yet.
TEST_F(Resume, AfterTerminationByTheLineThatItLeaves)
{
  write("my case.prm", "include " + tiny_pull_out + "\n");
  Words words = pull_out("run");
  words.front() = "my case.prm";
  summary_of_run(pull_out("undisturbed"));
  for (const bool in_pull : {false, true}) {
    fs::remove_all(folder / "run");
    const Ending ending =
        stop(SIGTERM, words,
             in_pull ? when_rows("run", 8) : when_logged("run", "fill lower half: "));
    ASSERT_EQ(ending.code, 130) << ending.out << ending.err;
    EXPECT_FALSE(fs::exists(folder / "run" / "summary.json"));
    EXPECT_NE(ending.err.find("run/checkpoint.h5"), std::string::npos) << ending.err;
    const std::string before = "go on with: interlock ";
    const std::size_t at = ending.err.find(before);
    ASSERT_NE(at, std::string::npos) << ending.err;
    std::string line = ending.err.substr(at + before.size());
    line.erase(line.find('\n'));
    EXPECT_NE(line.find(" --resume"), std::string::npos) << line;
    const std::string command = "cd '" + folder.string() + "' && '" INTERLOCK_PROGRAM "' " + line +
                                " >resumed.out 2>resumed.err";
    EXPECT_EQ(std::system(command.c_str()), 0) << line << text_of(folder / "resumed.err");
    EXPECT_NE(text_of(folder / "resumed.out").find("Going on from "), std::string::npos);
    expect_same_run("undisturbed", "run");
  }
}

TEST_F(Resume, AfterAKillInThePull)
{
  summary_of_run(pull_out("undisturbed"));
  ASSERT_EQ(stop(SIGKILL, pull_out("run"), when_rows("run", 12)).code, -SIGKILL);
  summary_of_run(resumed(pull_out("run")));
  expect_same_run("undisturbed", "run");
}

// Killed before each stage but the first has left its checkpoint for a quarter of a second, so
// again and again in one run.
TEST_F(Resume, AfterAKillInEveryStage)
{
  summary_of_run(pull_out("undisturbed"));
  Words words = pull_out("run");
  for (const char* text :
       {"stones: ", "fill lower half: ", "place geogrid: ", "fill upper half: "}) {
    const Ending ending = stop(SIGKILL, words, when_logged("run", text));
    ASSERT_EQ(ending.code, -SIGKILL) << text << ending.err;
    words = resumed(pull_out("run"));
  }
  summary_of_run(words);
  expect_same_run("undisturbed", "run");
}

// A row that a kill has torn, rows and frames beyond the checkpoint, and a left-over part of a
// file.
TEST_F(Resume, CutsOffWhatIsBeyondTheCheckpoint)
{
  const Words no_timer = pull_out("run", {"Output/Checkpoint interval=0"});
  summary_of_run(pull_out("undisturbed", {"Output/Checkpoint interval=0"}));
  // The last checkpoint is the one at the begin of the pull.
  ASSERT_EQ(stop(SIGKILL, no_timer, when_rows("run", 15)).code, -SIGKILL);
  std::ofstream(folder / "run" / "history.csv", std::ios::app) << "0.1,0.2,0.";
  std::ofstream(folder / "run" / "checkpoint.h5.part") << "half";
  summary_of_run(resumed(no_timer));
  expect_same_run("undisturbed", "run");
}

TEST_F(Resume, OfAFinishedRunGivesTheSameSummary)
{
  const json before = summary_of_run(pull_out("run"));
  const auto files = results("run");
  const json after = summary_of_run(resumed(pull_out("run")));
  EXPECT_EQ(without_wall_times(after), without_wall_times(before));
  EXPECT_TRUE(results("run") == files);
}

TEST_F(Resume, WithNothingThereStartsFromTheBeginningAndSaysSo)
{
  const json undisturbed = summary_of_run(pull_out("undisturbed"));
  const Ending ending = run(resumed(pull_out("run")));
  ASSERT_EQ(ending.code, 0) << ending.err;
  EXPECT_NE(ending.out.find("There is no checkpoint in run"), std::string::npos) << ending.out;
  EXPECT_NE(ending.out.find("from the beginning"), std::string::npos) << ending.out;
  expect_same_run("undisturbed", "run");
}

// The refused run leaves everything as it was, so that it can be resumed with its own entries.
TEST_F(Resume, WithAnotherEntryIsRefused)
{
  summary_of_run(pull_out("undisturbed"));
  stop(SIGKILL, pull_out("run"), when_logged("run", "fill lower half: "));
  const std::string used = text_of(folder / "run" / "used.prm"),
                    checkpoint = text_of(folder / "run" / "checkpoint.h5");
  expect_sentence(run(resumed(pull_out("run", {"Contact/Stone friction=0.55"}))), 2,
                  {"checkpoint.h5", "Contact/Stone friction", "0.6", "0.55"});
  EXPECT_EQ(text_of(folder / "run" / "used.prm"), used);
  EXPECT_TRUE(text_of(folder / "run" / "checkpoint.h5") == checkpoint);
  // How often a checkpoint is written says nothing about what comes out.
  summary_of_run(resumed(pull_out("run", {"Output/Checkpoint interval=7"})));
  expect_same_run("undisturbed", "run");
}

TEST_F(Resume, FromADamagedCheckpointIsRefused)
{
  stop(SIGKILL, pull_out("run"), when_logged("run", "place geogrid: "));
  const fs::path file = folder / "run" / "checkpoint.h5";
  ASSERT_TRUE(fs::exists(file));
  std::string bytes = text_of(file);
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(file, std::ios::binary) << bytes;
  expect_sentence(run(resumed(pull_out("run"))), 2,
                  {"checkpoint.h5", "damaged", "checkpoint.previous.h5"});
  std::ofstream(file, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  expect_sentence(run(resumed(pull_out("run"))), 2, {"checkpoint.h5", "cut off"});
  EXPECT_FALSE(fs::exists(folder / "run" / "summary.json"));
  // As the sentence says.
  summary_of_run(pull_out("undisturbed"));
  fs::rename(folder / "run" / "checkpoint.previous.h5", file);
  summary_of_run(resumed(pull_out("run")));
  expect_same_run("undisturbed", "run");
}

// A kill between the two renames of a checkpoint leaves the one before only.
TEST_F(Resume, GoesOnFromTheCheckpointBefore)
{
  summary_of_run(pull_out("undisturbed"));
  stop(SIGKILL, pull_out("run"), when_rows("run", 8));
  fs::remove(folder / "run" / "checkpoint.h5");
  ASSERT_TRUE(fs::exists(folder / "run" / "checkpoint.previous.h5"));
  summary_of_run(resumed(pull_out("run")));
  expect_same_run("undisturbed", "run");
}

TEST_F(Resume, OfAHeap)
{
  const auto heap = [](const std::string& output) {
    return Words{
        tiny_heap,  "--set", "Output/Report=false", "--set", "Output/Checkpoint interval=0.1",
        "--output", output};
  };
  const json undisturbed = summary_of_run(heap("undisturbed"));
  // Some ten rows before the end of the drop, which leaves a few times as many.
  ASSERT_EQ(stop(SIGKILL, heap("run"), when_rows("run", 5)).code, -SIGKILL);
  summary_of_run(resumed(heap("run")));
  expect_same_run("undisturbed", "run");
}

TEST_F(Resume, StartFromTheStateBeforeThePullRepeatsThePull)
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
TEST_F(Resume, StartFromTheStateBeforeThePullWithAnotherPull)
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
TEST_F(Resume, StartFromTheStateBeforeThePullWithAnotherModulus)
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

TEST_F(Resume, StartFromTheStateBeforeThePullWithASurcharge)
{
  summary_of_run(pull_out("first"));
  const json loaded = summary_of_run(
      pull_out("loaded", {"Start from=" + (folder / "first/state_before_pull.h5").string(),
                          "Surcharge/Force=20", "Surcharge/Sphere radius=0.025"}));
  EXPECT_EQ(stages_of(loaded), (Words{"start", "adapt", "surcharge", "settle", "pull"}));
  EXPECT_EQ(loaded["results"]["surcharge_N"], 20);
  EXPECT_LT(loaded["energy"]["relative_error"].get<double>(), 0.01);
}

TEST_F(Resume, StartFromTheStateBeforeTheGeogridWithAnotherPitch)
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
TEST_F(Resume, StartFromWhatDoesNotFitIsRefused)
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

TEST_F(Resume, StartFromAHeapIsRefused)
{
  summary_of_run({tiny_heap, "--set", "Output/Report=false", "--output", "heap"});
  expect_sentence(
      run(pull_out("refused", {"Start from=" + (folder / "heap/checkpoint.h5").string()})), 2,
      {"checkpoint.h5", "heap", "pull-out"});
  EXPECT_FALSE(fs::exists(folder / "refused"));
}

TEST_F(Resume, ARibThatBreaksEndsTheRun)
{
  expect_sentence(run(pull_out("run", {"Geogrid/Break strain=1e-6"})), 3,
                  {"rib breaks", "t = ", " s (step ", "element ", "Geogrid/Break strain"});
  EXPECT_TRUE(fs::is_regular_file(folder / "run/state_at_failure.h5"));
  EXPECT_FALSE(fs::exists(folder / "run/summary.json"));
  EXPECT_NE(text_of(folder / "run/run.log").find("Stopped: A rib breaks"), std::string::npos);
}

TEST_F(Resume, AnOverlapBeyondItsLimitEndsTheRun)
{
  expect_sentence(run(pull_out("run", {"Limits/Overlap=1e-6"})), 3,
                  {"overlap", "stone", "t = ", " s (step ", "limit"});
  EXPECT_TRUE(fs::is_regular_file(folder / "run/state_at_failure.h5"));
  EXPECT_FALSE(fs::exists(folder / "run/summary.json"));
}
