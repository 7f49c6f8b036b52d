// The form of one piece of broken rock without its roughness: a body that every ray from the origin
// leaves once (star-shaped), so that a mesh wrapped around it is closed and cannot cut itself.
#pragma once

#include "dem/random_stream.h"
#include "dem/stones/stone_style.h"

namespace interlock::dem
{
// Given as a gauge, a function of the direction that is homogeneous of degree 1: the point x lies
// inside where gauge(x) < 1. Cutting a body takes the larger of two gauges, adding one the smaller.
// The larger is rounded off by edge_wear, which is what wears convex edges. Lengths are relative:
// the longest semi-axis is near 1.
class Fragment
{
public:
  // Draws a form of this style. Equal streams and styles give equal forms.
  Fragment(const StoneStyle& style, RandomStream& random);

  // Drawn proportions: semi-axes along x, y, z in descending order, the first is 1. Cutting changes
  // them unevenly; whoever wraps a mesh stretches it back.
  const Vector3& semi_axes() const { return semi_axes_; }

  // Where the ray along `direction` (any length) from the origin leaves the body.
  Vector3 surface_point(const Vector3& direction) const { return direction / gauge(direction); }

  double gauge(const Vector3& x) const;

private:
  // A cut: all beyond a plane, or all inside a ball (the hollow of a scar), is taken away. `normal`
  // is a unit vector, `distance` > 0 that of the plane, or of the point of the ball nearest to the
  // origin, which lies along `normal`. A plane has an infinite `radius`.
  struct Face {
    Vector3 normal;
    double distance, radius;
    double gauge(const Vector3& x) const;
  };
  // A flake that broke off: all beyond both planes is taken away.
  struct Step {
    Face floor, riser;
  };

  void draw_faces(const StoneStyle& style, RandomStream& random);
  void draw_scars(const StoneStyle& style, RandomStream& random);
  void chip_bare_corners(RandomStream& random);
  void draw_steps(const StoneStyle& style, RandomStream& random);
  double touching_distance(const Vector3& normal) const;

  Vector3 semi_axes_;
  double wear_;
  std::vector<Face> faces_;
  std::vector<Step> steps_;
};
} // namespace interlock::dem
