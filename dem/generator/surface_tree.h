// The facets of a surface in a search tree, for nearest points.
#pragma once

#include "dem/meshes/triangle_mesh.h"

#include <memory>

namespace interlock::dem
{
// Point of the triangle with corners a, b, c that is nearest to x; any frame [m]. Source: the
// regions of corners, edges and face, e.g. Ericson, Real-Time Collision Detection (2005), 5.1.5.
Vector3 nearest_on_triangle(const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

// Keeps a reference to the mesh, which must outlive the tree.
class SurfaceTree
{
public:
  explicit SurfaceTree(const TriangleMesh& mesh);
  ~SurfaceTree();

  struct Nearest {
    int facet = -1; // -1: none within reach
    Vector3 point;  // [m]
    double distance = 0;
  };
  // Which facets a search looks at.
  enum class Facets {
    all,
    ahead, // not at `node`, and their outward normal has a positive part along `direction`
    beside // not at `node`, and it has none
  };
  // The nearest point of those facets that is nearer to x than `reach` [m].
  Nearest nearest(const Vector3& x, double reach, Facets which = Facets::all, int node = -1,
                  const Vector3& direction = Vector3::Zero()) const;

  // Whether every facet at `node` has a positive part of its outward normal along `outward`: the
  // surface is then a height field around the node, and the body lies below it.
  bool is_outward(int node, const Vector3& outward) const;

private:
  struct Tree;
  Vector3 area_vector(int facet) const; // outward, twice the area long [m2]
  const TriangleMesh& mesh_;
  std::vector<int> first_, around_; // facets around node v: around_[first_[v]] .. [first_[v + 1]]
  std::unique_ptr<const Tree> tree_;
};
} // namespace interlock::dem
