// Which of n items hang together (disjoint sets).
#pragma once

#include <numeric>
#include <vector>

namespace interlock::dem
{
// Each item starts as a part of its own. Source: Tarjan and van Leeuwen, J. ACM 31(2) (1984), with
// path halving.
class ConnectedParts
{
public:
  explicit ConnectedParts(std::size_t items) : parent_(items)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  // The item that stands for the part of `item`.
  int part(int item)
  {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  void join(int a, int b) { parent_[part(b)] = part(a); }

private:
  std::vector<int> parent_;
};
} // namespace interlock::dem
