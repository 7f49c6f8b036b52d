// A closed surface as the clump generator sees it: a mesh or a cloud of points.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/meshes/mass_properties.h"

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace interlock::dem
{
struct ClumpSurface {
  const std::vector<Vector3>& nodes;
  std::vector<Vector3> outward; // unit normals of the nodes
  // The largest ball at a node along its inward normal; radius 0 or infinite: there is none.
  std::function<Sphere(int node, const Vector3& inward)> ball;
  // Of the piece of the surface that each node stands for, in any unit.
  std::function<std::vector<double>()> areas;
  MassProperties mass;

  // The ball at a node, if there is one of radius r_min [m] or more.
  std::optional<Sphere> ball_at(int node, double r_min) const
  {
    const Sphere sphere = ball(node, -outward[node]);
    if (sphere.radius > 0 && std::isfinite(sphere.radius) && sphere.radius >= r_min) return sphere;
    return std::nullopt;
  }

  Eigen::AlignedBox3d box() const // around the nodes
  {
    Eigen::AlignedBox3d box;
    for (const Vector3& node : nodes) box.extend(node);
    return box;
  }
};

// Lengths [m] of a surface in this box that are rounding. A sphere touches the node on its far side
// to within it, which must not count as nearer than d_min = 0.
inline double rounding_length(const Eigen::AlignedBox3d& box)
{
  return 1e-9 * box.sizes().maxCoeff();
}
} // namespace interlock::dem
