// Where two straight segments come closest.
#pragma once

#include <Eigen/Dense>

namespace interlock::fem
{
// A closest pair of points, one on each segment [m].
struct ClosestPoints {
  Eigen::Vector3d first, second;
  double distance() const { return (second - first).norm(); }
};

// Of the segments from a0 to a1 and from b0 to b1, both of positive length (Ericson, Real-Time
// Collision Detection (2005), section 5.1.9). Of parallel segments it is one of many such pairs.
ClosestPoints closest_points(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                             const Eigen::Vector3d& b0, const Eigen::Vector3d& b1);
} // namespace interlock::fem
