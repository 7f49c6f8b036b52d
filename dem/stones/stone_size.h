// How large a stone is and which form it has, as engineers measure it.
#pragma once

#include "dem/meshes/mass_properties.h"
#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// Axes are the principal axes of inertia of the closed body, the longest first; extents are
// measured along them. The ratios are those of Zingg (1935).
struct StoneSize {
  double longest = 0, intermediate = 0, shortest = 0; // L, I, S [m]
  double sieve = 0;                                   // see sieve_size() [m]
  double sphericity = 0; // area of the ball of equal volume / area of the stone (Wadell 1932)

  double flatness() const { return shortest / intermediate; }
  double elongation() const { return intermediate / longest; }
};
StoneSize stone_size(const TriangleMesh& mesh);

// The same of points on the surface of `body`, whose area is `area` [m2].
StoneSize stone_size(const std::vector<Vector3>& points, const MassProperties& body, double area);

// Side of the smallest square opening that lets the stone through end-on, along `direction` (unit
// vector): the smallest square around its shadow, over all angles of the square to a tenth of a
// degree.
double sieve_size(const std::vector<Vector3>& points, const Vector3& direction); // [m]
} // namespace interlock::dem
