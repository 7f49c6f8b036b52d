// The largest ball that touches a surface from inside at one of its nodes: by its nodes, as the
// paper has it, or by its facets.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/generator/surface_tree.h"

#include <memory>
#include <vector>

namespace interlock::dem
{
// Nodes of one surface in a search tree. Copies the nodes.
class BallAmongNodes
{
public:
  // `nodes` in any frame [m].
  explicit BallAmongNodes(const std::vector<Vector3>& nodes);
  ~BallAmongNodes();

  // Radius [m] of the largest ball that touches nodes[node], has its centre at
  // nodes[node] + radius * inward (unit vector), and has no node strictly inside:
  //   min over q with (q - p).inward > 0 of |q - p|^2 / (2 (q - p).inward).
  // Infinite where no node limits it to half the diagonal of the box around the nodes: such a ball
  // is larger than the stone, so the normal points out of it. Source: Ferellec and McDowell (2010),
  // section 2 and Fig. 1.
  double radius(int node, const Vector3& inward) const;

  double half_diagonal() const { return half_diagonal_; } // of the box around the nodes [m]

private:
  struct Tree;
  std::vector<Vector3> nodes_;
  double half_diagonal_ = 0;
  std::unique_ptr<const Tree> tree_;
};

// Facets of one closed, outward mesh, which must outlive this.
class BallInsideSurface
{
public:
  explicit BallInsideSurface(const TriangleMesh& mesh);

  // The largest ball with its centre on `inward` (unit vector) from the node that lies inside the
  // polyhedron and touches it there. Facets ahead limit it exactly. Facets that meet at the node,
  // and what the neighbours' tilt cuts off within 1 % of the radius, are how a mesh is curved: they
  // do not move the centre, but the ball is made to fit inside them. On a fine mesh of a smooth
  // body it differs from the ball among nodes by the sagitta of a facet. Radius 0 where `inward`
  // does not lead into the body. Method: docs/theory/clumps.md.
  Sphere at(int node, const Vector3& inward) const;

private:
  const TriangleMesh& mesh_;
  BallAmongNodes nodes_;
  SurfaceTree facets_;
};
} // namespace interlock::dem
