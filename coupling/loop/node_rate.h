// How fast contacts make nodes of the geogrid swing: what the number of sub-steps goes by.
#pragma once

#include <cstdint>

namespace interlock::coupling
{
// A bound on the squared frequencies that contacts give a node of the lattice [1/s2].
struct NodeRate {
  std::int64_t node;
  double rate; // a multiple of 1024: sums of them know no order
};

inline NodeRate node_rate(std::int64_t node, double rate)
{
  constexpr double shift = 1.5 * static_cast<double>(1ull << 62); // rounds to multiples of 2^10
  return {node, (rate + shift) - shift};
}
} // namespace interlock::coupling
