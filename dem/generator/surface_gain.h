// What a sphere adds to the shape of a clump: the distance of the stone's surface that it takes
// away.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <vector>

namespace interlock::dem
{
// Points of the surface, each with the area that it stands for and its distance from the union of
// the spheres so far; a point within a sphere has none. Without a sphere every distance is the
// diagonal of the box around the points. Why distance, and not volume: docs/theory/clumps.md.
class SurfaceGain
{
public:
  // Any frame; points [m] and areas [m2], as many of one as of the other.
  SurfaceGain(const std::vector<Vector3>& points, const std::vector<double>& areas);

  // Sum of area times the distance that the sphere takes away [m3]; to first order the volume of
  // the layer between stone and clump that it fills. Never grows when spheres are added.
  double gain(const Sphere& sphere) const;

  void add(const Sphere& sphere);

  double distance(int point) const { return distance_[point]; } // [m]
  double area() const { return area_.sum(); }                   // of all points [m2]

private:
  Eigen::ArrayXd distances_from(const Sphere& sphere) const;
  Eigen::ArrayXd x_, y_, z_, area_, distance_;
};
} // namespace interlock::dem
