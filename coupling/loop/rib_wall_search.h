// Which ribs may touch the box within a step: a search that most vertices end at once.
#pragma once

#include "coupling/loop/rib_wall_points.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
// Which vertices, and ribs that begin at them, could be near any wall: coordinates alone, in vector
// lanes, since most never are.
class RibWallSearch
{
public:
  static constexpr int block = 64;

  RibWallSearch(const RibBox& box, const dem::RibSet& ribs, double dt)
      : ribs_(ribs), width_(box.width), length_(box.length), dt_(dt),
        reach_(ribs.largest_half_girth()), margin_(0.01 * ribs.largest_half_thickness())
  {
  }

  // How much nearer the vertex, or the rib that begins there, may come within the step: the factor
  // and the margin leave room for what kicks do in it [m].
  double room(int vertex, bool of_rib) const
  {
    const auto speed = [&](int end) { return dem::Vector3(ribs_.velocity[end]).lpNorm<1>(); };
    return margin_ +
           2 * dt_ * (of_rib ? std::max(speed(vertex), speed(vertex + 1)) : speed(vertex));
  }

  // Those from `first` on. Where no rib begins the next vertex is another line's, or not known: it
  // can only add to what is near.
  void find(int first, int n, bool* is_near) const
  {
    const double *x = ribs_.position.row(0), *y = ribs_.position.row(1), *z = ribs_.position.row(2);
    const double *u = ribs_.velocity.row(0), *v = ribs_.velocity.row(1), *w = ribs_.velocity.row(2);
    const int last = ribs_.position.size() - 1;
    for (int k = 0; k < n; ++k) {
      const int i = first + k, j = std::min(i + 1, last);
      const double speed = std::max(std::abs(u[i]) + std::abs(v[i]) + std::abs(w[i]),
                                    std::abs(u[j]) + std::abs(v[j]) + std::abs(w[j]));
      const double r = reach_ + margin_ + 2 * dt_ * speed;
      is_near[k] = (z[i] < r) | (y[i] < r) | (width_ - y[i] < r) | (length_ - x[i] < r) |
                   ((std::min(x[i], x[j]) < r) & (std::max(x[i], x[j]) > -r));
    }
  }

private:
  const dem::RibSet& ribs_;
  double width_, length_, dt_, reach_, margin_;
};
} // namespace interlock::coupling
