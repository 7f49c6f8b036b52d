// The state of a run as plain data: arrays under paths. What a field list writes and reads
// (state_archive.h), what a checkpoint file holds, what is hashed and compared.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace interlock::coupling
{
// Rows of `columns` values each; a single number is one row.
struct StateArray {
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;
  int columns = 1;
  std::string unit = {}; // "kg"; empty for pure numbers, counts and words

  std::size_t size() const; // values in all
};

// By path: "state/world/engine/clumps/position".
using StateTree = std::map<std::string, StateArray>;

// XXH3 (64 bit) over paths, shapes and values of all arrays whose path begins with `prefix`; every
// bit counts, so 0 and -0 differ.
std::uint64_t hash_of(const StateTree& tree, const std::string& prefix = "");

// One sentence about the first value that differs, bit by bit; empty when there is none.
std::optional<std::string> first_difference(const StateTree& a, const StateTree& b);
} // namespace interlock::coupling
