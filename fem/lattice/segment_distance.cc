#include "fem/lattice/segment_distance.h"

#include <algorithm>

namespace interlock::fem
{
ClosestPoints closest_points(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                             const Eigen::Vector3d& b0, const Eigen::Vector3d& b1)
{
  const Eigen::Vector3d along_a = a1 - a0, along_b = b1 - b0, gap = a0 - b0;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  const double a_gap = along_a.dot(gap), b_gap = along_b.dot(gap);
  const auto on_segment = [](double share) { return std::clamp(share, 0., 1.); };

  // Nearest to the other's straight line, then the other's nearest to that point, then back again
  // where the other's end was met.
  const double determinant = aa * bb - ab * ab;
  double s =
      determinant > 1e-14 * aa * bb ? on_segment((ab * b_gap - a_gap * bb) / determinant) : 0;
  const double t = on_segment((ab * s + b_gap) / bb);
  s = on_segment((ab * t - a_gap) / aa);
  return {a0 + s * along_a, b0 + t * along_b};
}
} // namespace interlock::fem
