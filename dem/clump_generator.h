// The clump generator of Ferellec and McDowell (2010, section 2) and the mass properties of its result
// (section 3 of the paper, or exactly from the mesh).
#pragma once

#include "dem/clump_shape.h"
#include "dem/mass_properties.h"

#include <cstdint>

namespace interlock::dem
{
enum class MassScheme {
  uniform,    // the same density in every sphere
  equal_mass, // the same mass in every sphere: the correction of the paper
  mesh        // volume, centre and inertia of the closed surface mesh
};

struct ClumpParameters {
  double d_min = 0;      // a node nearer than this to a sphere's surface gets no sphere [m]
  double r_min = 0;      // smaller spheres are rejected [m]
  double p_max = 100;    // stop when this share of the nodes has been used [%]
  MassScheme mass_scheme = MassScheme::mesh;
  std::uint64_t seed = 1; // of the order in which nodes are drawn
};

// What came out, against the closed mesh (all relative, except where a unit is given).
struct ClumpReport {
  int nodes = 0;           // of the mesh
  int nodes_used = 0;      // a ball was grown there, kept or rejected
  int rejected = 0;        // balls smaller than r_min
  // Per scheme (indexed by MassScheme): error of the principal moments (mean of the three absolute
  // relative errors), after scaling the mass to that of the mesh; offset of the centre [m].
  std::array<double, 3> inertia_error{};
  std::array<double, 3> centre_offset{};
  double surface_distance_mean = 0; // from the mesh nodes to the union of the spheres [m]
  double surface_distance_max = 0;  // [m]
};

// Throws InputError when no sphere is left (r_min too large) or a parameter is out of range.
ClumpShape make_clump(const TriangleMesh& stone, const ClumpParameters& parameters,
                      ClumpReport* report = nullptr);
} // namespace interlock::dem
