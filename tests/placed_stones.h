// Stones of a few spheres that a test puts where it wants them.
#pragma once

#include "coupling/stones/stone_shapes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

// Spheres of the same volume, with the centre of mass at their middle and the inertia of a brick.
inline interlock::coupling::Stone stone_of(std::vector<interlock::dem::Sphere> spheres)
{
  using interlock::dem::Vector3;
  interlock::coupling::Stone stone;
  stone.shape.name = "placed";
  Eigen::AlignedBox3d bounds;
  double largest = 0;
  for (const interlock::dem::Sphere& s : spheres) {
    bounds.extend(Vector3(s.centre.array() - s.radius));
    bounds.extend(Vector3(s.centre.array() + s.radius));
    largest = std::max(largest, s.radius);
  }
  stone.shape.volume = 4 * M_PI / 3 * std::pow(largest, 3) * double(spheres.size());
  const Vector3 d = bounds.sizes().cwiseAbs2();
  stone.shape.unit_inertia =
      stone.shape.volume / 12 * Vector3(d.y() + d.z(), d.x() + d.z(), d.x() + d.y());
  stone.shape.spheres = std::move(spheres);
  return stone;
}
