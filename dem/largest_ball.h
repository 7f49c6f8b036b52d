// The largest ball that touches a surface from inside at one of its nodes.
#pragma once

#include "dem/vector.h"

#include <memory>
#include <vector>

namespace interlock::dem
{
// Nodes of one surface in a search tree. Copies the nodes.
class LargestBall
{
public:
  // `nodes` in any frame [m].
  explicit LargestBall(const std::vector<Vector3>& nodes);
  ~LargestBall();

  // Radius [m] of the largest ball that touches nodes[node], has its centre at
  // nodes[node] + radius * inward (unit vector), and has no node strictly inside:
  //   min over q with (q - p).inward > 0 of |q - p|^2 / (2 (q - p).inward).
  // Infinite where no node limits it to half the diagonal of the box around the nodes: such a ball
  // is larger than the stone, so the normal points out of it. Source: Ferellec and McDowell (2010),
  // section 2 and Fig. 1.
  double radius(int node, const Vector3& inward) const;

  // Distance from `point` to the nearest node [m].
  double distance_to_nodes(const Vector3& point) const;

private:
  struct Tree;
  std::vector<Vector3> nodes_;
  double half_diagonal_ = 0; // of the box around the nodes [m]
  std::unique_ptr<const Tree> tree_;
};
} // namespace interlock::dem
