// What every answer to bad input has in common: one InputError, one sentence, the file and the
// facts in it.
#pragma once

#include "dem/input_error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Expects that `read` refuses `file` with a sentence on one line that contains the file's name and
// all of `facts`.
template <class Read>
void expect_refusal(const Read& read, const std::string& file,
                    const std::vector<std::string>& facts)
{
  try {
    read();
    ADD_FAILURE() << file << " was accepted";
  } catch (const interlock::InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(file), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
    for (const std::string& fact : facts) EXPECT_NE(text.find(fact), std::string::npos) << text;
  }
}
