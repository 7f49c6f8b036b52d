// Whether two facets of a surface cut through each other.
#pragma once

#include "dem/meshes/triangle_mesh.h"

#include <optional>

namespace interlock::dem
{
using Triangle = std::array<int, 3>; // indices into the vertices of a mesh

// Method: Moeller, J. Graphics Tools 2(2) (1997): on the line where the planes of two facets meet
// each facet has an interval, and they cross where the intervals overlap. Distances from a plane
// within the tolerance count as zero, and touching is no crossing; so are facets in one plane.
class FacetCrossing
{
public:
  // Keeps a reference to `mesh`.
  explicit FacetCrossing(const TriangleMesh& mesh);

  // The rounding of single precision: 2.4e-7 of the largest coordinate [m].
  double tolerance() const { return tolerance_; }

  // A point where the two facets cut through each other, if they do [m]. Facets that share an edge
  // never do, facets that share a vertex only away from it.
  std::optional<Vector3> operator()(const Triangle& a, const Triangle& b) const;

private:
  // Signed distances of the corners of a facet from the plane of another one [m].
  using Distances = std::array<double, 3>;
  struct Interval {
    double first, last; // positions on the line where the planes meet
    Vector3 point;      // one of its ends
  };

  const Vector3& corner(const Triangle& t, int k) const { return mesh_.vertices[t[k]]; }
  Vector3 normal(const Triangle& t) const;
  Distances distances(const Triangle& t, const Triangle& other, const Vector3& normal) const;
  Interval interval(const Triangle& t, const Distances& d, const Vector3& along) const;

  const TriangleMesh& mesh_;
  double tolerance_;
};
} // namespace interlock::dem
