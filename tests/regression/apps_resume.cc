// Runs that are stopped or killed, and resumed, through the program itself. It takes one digit of
// hash, history or frame that differs from the undisturbed run, an exit code or a sentence that
// does not say what happened, a checkpoint taken for good that does not fit the case, or a refusal
// that touches the results it refuses, to fail.
#include "tests/stopped_run.h"

#include <cstdlib>

using namespace stopped_run;

namespace
{
class Resume : public StoppedRunTest
{
};
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
    const Ending ending = stop(
        SIGTERM, words, in_pull ? when_rows("run", 8) : when_logged("run", "fill lower half: "));
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
