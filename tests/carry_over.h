// An object written into a state file and read into another one, and whether both are the same.
#pragma once

#include "coupling/state/checkpoint_file.h"
#include "coupling/state/state_archive.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace carry
{
using namespace interlock::coupling;

// Both go by the same digits or by none.
template <class T> void expect_same(const T& a, const T& b, const std::string& when)
{
  StateTree one, two;
  StateWriter(one, "state/")("whole", a);
  StateWriter(two, "state/")("whole", b);
  ASSERT_EQ(first_difference(one, two), std::nullopt) << when;
  ASSERT_EQ(hash_of(one), hash_of(two)) << when;
}

// Through a file, as a checkpoint goes.
template <class T> void carry_over(const T& from, T& to, const std::filesystem::path& file)
{
  StateTree tree, again;
  StateWriter(tree, "state/")("whole", from);
  write_state(file, tree, "1.2.3");
  const StateTree read = read_state(file);
  ASSERT_EQ(first_difference(read, tree), std::nullopt);
  StateReader reader(read, "state/");
  reader("whole", to);
  reader.expect_all_read();
  StateWriter(again, "state/")("whole", to);
  ASSERT_EQ(first_difference(again, tree), std::nullopt) << "saved again";
}
} // namespace carry
