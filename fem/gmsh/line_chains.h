// Single line elements, in any order, put together to long lines.
#pragma once

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace interlock::fem
{
struct ChainLink {
  std::array<int, 2> node{};
  Eigen::Vector3d normal{0, 0, 1}; // links of one chain have the same
};

struct Chain {
  std::vector<int> nodes; // in order, one more than links; first and last are equal in a ring
  std::vector<int> links; // in order
};

// At each node, two links of equal normal whose directions differ by less than 45 degrees follow
// each other in a chain, the straightest pair first; where several pairs are equally straight, the
// one with the smaller numbers. Every link is in one chain. Chains are in the order of their
// smallest link and run in that link's direction. Links must have positive length.
std::vector<Chain> straightest_chains(const std::vector<Eigen::Vector3d>& positions,
                                      const std::vector<ChainLink>& links);
} // namespace interlock::fem
