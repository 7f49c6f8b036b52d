// Runs of the program itself that a signal stops or kills, and the comparison of what two runs have
// left behind.
#pragma once

#include "tests/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace stopped_run
{
namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

const std::string tiny_pull_out = INTERLOCK_SOURCE_DIR "/tests/regression/tiny_pull_out.prm";
const std::string tiny_heap = INTERLOCK_SOURCE_DIR "/tests/regression/tiny_heap.prm";

inline std::string text_of(const fs::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

inline std::size_t lines_of(const fs::path& file)
{
  const std::string text = text_of(file);
  return std::count(text.begin(), text.end(), '\n');
}

// Without what a clock measured, at any depth.
inline json without_wall_times(const json& value)
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

// How a process ended and what it said.
struct Ending {
  int code = -1; // exit code, or minus the signal that killed it
  std::string out, err;
};

class StoppedRunTest : public TemporaryFolderTest
{
protected:
  std::string program = INTERLOCK_PROGRAM;

  // Starts "interlock run" in the test's folder.
  pid_t start(const Words& words) const
  {
    Words all = {program, "run"};
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
    if (chdir(folder.c_str()) == 0) execv(program.c_str(), arguments.data());
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

inline Words pull_out(const std::string& output, const Words& entries = {})
{
  Words words = {tiny_pull_out, "--set", "Output/Report=false", "--set",
                 "Output/Checkpoint interval=0.2"};
  for (const std::string& entry : entries) words.insert(words.end(), {"--set", entry});
  words.insert(words.end(), {"--output", output});
  return words;
}

inline Words resumed(Words words)
{
  words.emplace_back("--resume");
  return words;
}

// One line for people, with all of the facts in it.
inline void expect_sentence(const Ending& ending, int code, const Words& facts)
{
  EXPECT_EQ(ending.code, code) << ending.out << ending.err;
  EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1) << ending.err;
  EXPECT_NE(ending.err.find(".\n"), std::string::npos) << ending.err;
  for (const std::string& fact : facts)
    EXPECT_NE(ending.err.find(fact), std::string::npos) << fact << " is not in: " << ending.err;
}

} // namespace stopped_run
