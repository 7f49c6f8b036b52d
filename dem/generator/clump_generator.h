// The clump generator of Ferellec and McDowell (2010, section 2) and the mass properties of its
// result (section 3 of the paper, or exactly from the surface). Method: docs/theory/clumps.md.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/generator/clump_report.h"
#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/point_cloud.h"

#include <cstdint>

namespace interlock::dem
{
// How far a ball grows: until a facet touches it, or until a node does (the paper's; sticks out of
// large facets). See largest_ball.h.
enum class TouchingRadius { surface, nodes };

// Which ball comes next: that of a node drawn at random (the paper's), or the one that adds most to
// the shape (gain_order.h).
enum class SphereOrder { random, gain };

struct ClumpParameters {
  double d_min = 0;   // a node nearer than this to a sphere's surface gets no sphere [m]
  double r_min = 0;   // smaller spheres are rejected [m]
  double p_max = 100; // stop when this share of the nodes has been used [%]
  TouchingRadius touching_radius = TouchingRadius::surface;
  MassScheme mass_scheme = MassScheme::mesh;
  std::uint64_t seed = 1; // of the order in which nodes are drawn
  SphereOrder sphere_order = SphereOrder::random;
  // By how much spheres may stand out of the surface, so that their union has the stone's volume
  // [m]: each is made larger by the same length, no more than is needed (bulge.h).
  double bulge = 0;
  // More stop rules; 0 leaves a rule out. The first that holds stops.
  int max_spheres = 0;
  double target_volume_error = 0;  // |volume of the union - stone|/stone
  double target_inertia_error = 0; // of the mass scheme, which must not be `mesh`: it has none
};

// Throws InputError when a parameter is out of range; make_clump does so too.
void check_parameters(const ClumpParameters& parameters);

// Takes the nodes of the closed, outward mesh `stone` in the order asked for; skips a node nearer
// than d_min to the surface of a kept sphere; grows the largest ball that touches the node from
// inside; rejects it below r_min; stops when p_max per cent of the nodes are used (see
// ClumpReport::nodes_used), or by another stop rule; bulges. Deterministic from the seed. The mass
// is always that of the mesh; centre, axes and inertia are those of the scheme. Spheres come out in
// descending radius. `report` gets the errors of all schemes. Throws InputError when no sphere is
// left (r_min too large) or a parameter is out of range.
ClumpShape make_clump(const TriangleMesh& stone, const ClumpParameters& parameters,
                      ClumpReport* report = nullptr);

// The same of a cloud of points that encloses `body` (cloud_cells.h). Balls grow until a point
// touches them: the touching radius of `parameters` must be `nodes`, for a cloud has no facets.
ClumpShape make_clump(const PointCloud& stone, const MassProperties& body,
                      const ClumpParameters& parameters, ClumpReport* report = nullptr);

// "uniform", "equal-mass" or "mesh". Throws InputError for other names.
MassScheme mass_scheme(const std::string& name);

// "surface" or "nodes". Throws InputError for other names.
TouchingRadius touching_radius(const std::string& name);

// "random" or "gain". Throws InputError for other names.
SphereOrder sphere_order(const std::string& name);
} // namespace interlock::dem
