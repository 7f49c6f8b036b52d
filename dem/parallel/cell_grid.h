// Cubes that space is divided into: what ranks own, and how they find their neighbours.
#pragma once

#include "dem/vector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace interlock::dem
{
// Clumps whose centres are nearer than `width` to each other lie in the same cell or in neighbours,
// which share a face, an edge or a corner. Whoever is outside belongs to the cell at the border
// that is nearest along each axis, which keeps this true.
class CellGrid
{
public:
  // Cells of `width` [m] over the box from `low` to `high` (world) [m].
  CellGrid(const Vector3& low, const Vector3& high, double width) : low_(low), width_(width)
  {
    for (int c = 0; c < 3; ++c)
      n_[c] = std::max(1, static_cast<int>(std::ceil((high[c] - low[c]) / width)));
  }

  double width() const { return width_; }
  int size() const { return n_[0] * n_[1] * n_[2]; }

  int cell_of(const Vector3& x) const
  {
    int index[3];
    for (int c = 0; c < 3; ++c)
      // The order of the arguments makes 0 of what is not a number.
      index[c] = static_cast<int>(std::min(std::max(0., std::floor((x[c] - low_[c]) / width_)),
                                           static_cast<double>(n_[c] - 1)));
    return number(index[0], index[1], index[2]);
  }

  // From a place to the nearest point of a cell; cells at the border reach out for ever [m].
  double distance(const Vector3& x, int cell) const
  {
    const int index[3] = {cell % n_[0], cell / n_[0] % n_[1], cell / (n_[0] * n_[1])};
    Vector3 apart = Vector3::Zero();
    for (int c = 0; c < 3; ++c) {
      const double begin = low_[c] + index[c] * width_, below = begin - x[c],
                   above = x[c] - (begin + width_);
      if (index[c] > 0 && below > 0) apart[c] = below;
      if (index[c] < n_[c] - 1 && above > 0) apart[c] = above;
    }
    return apart.norm();
  }

  // The other cells that share something with this one, ascending.
  std::vector<int> neighbours(int cell) const
  {
    const int x = cell % n_[0], y = cell / n_[0] % n_[1], z = cell / (n_[0] * n_[1]);
    std::vector<int> cells;
    for (int k = std::max(0, z - 1); k <= std::min(n_[2] - 1, z + 1); ++k)
      for (int j = std::max(0, y - 1); j <= std::min(n_[1] - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(n_[0] - 1, x + 1); ++i)
          if (number(i, j, k) != cell) cells.push_back(number(i, j, k));
    return cells;
  }

private:
  int number(int x, int y, int z) const { return (z * n_[1] + y) * n_[0] + x; }

  Vector3 low_;
  double width_;
  int n_[3];
};
} // namespace interlock::dem
