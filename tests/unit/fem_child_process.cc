// Work in a process of its own. Fails when an answer is cut or changed, or when the end of that
// process, however it comes, is more than a sentence to this one.
#include "fem/gmsh/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

#include <unistd.h>

using interlock::fem::in_child_process;

namespace
{
std::string sentence_of(const std::function<std::string()>& work)
{
  try {
    in_child_process(work, "It crashed.");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}
} // namespace

TEST(ChildProcess, GivesBackEveryByte)
{
  EXPECT_EQ(in_child_process([] { return std::string(); }, "It crashed."), "");
  std::string long_one; // more than a pipe holds
  for (int n = 0; n < 1000000; ++n) long_one += static_cast<char>(n % 251);
  EXPECT_TRUE(in_child_process([&] { return long_one; }, "It crashed.") == long_one);
}

TEST(ChildProcess, PassesExceptionsOn)
{
  EXPECT_EQ(sentence_of([]() -> std::string { throw std::logic_error("No luck."); }), "No luck.");
}

TEST(ChildProcess, SurvivesEveryEnd)
{
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGKILL, SIGTERM})
    EXPECT_EQ(sentence_of([signal]() -> std::string {
                std::raise(signal);
                return "";
              }),
              "It crashed.")
        << signal;
  for (const int code : {0, 1, 3})
    EXPECT_EQ(sentence_of([code]() -> std::string { _exit(code); }), "It crashed.") << code;
}

TEST(ChildProcess, ChangesNothingHere)
{
  int here = 1;
  EXPECT_EQ(in_child_process(
                [&] {
                  here = 2;
                  return std::to_string(here);
                },
                "It crashed."),
            "2");
  EXPECT_EQ(here, 1);
}
