// The clump generator of Ferellec and McDowell (2010, section 2) and the mass properties of its
// result (section 3 of the paper, or exactly from the mesh).
#pragma once

#include "dem/clump_report.h"
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
  double d_min = 0;   // a node nearer than this to a sphere's surface gets no sphere [m]
  double r_min = 0;   // smaller spheres are rejected [m]
  double p_max = 100; // stop when this share of the nodes has been used [%]
  MassScheme mass_scheme = MassScheme::mesh;
  std::uint64_t seed = 1; // of the order in which nodes are drawn
};

// Draws the nodes of the closed, outward mesh `stone` in random order; skips a node nearer than
// d_min to the surface of a kept sphere; grows the largest ball that touches the node from inside
// (largest_ball.h); rejects it below r_min; stops when p_max per cent of the nodes have had a ball
// grown, kept or rejected. Deterministic from the seed. The mass is always that of the mesh;
// centre, axes and inertia are those of the scheme. Spheres come out in descending radius. `report`
// also gets the errors of all schemes. Throws InputError when no sphere is left (r_min too large)
// or a parameter is out of range.
ClumpShape make_clump(const TriangleMesh& stone, const ClumpParameters& parameters,
                      ClumpReport* report = nullptr);

// Mass properties of the spheres, in the frame of the mesh, as `scheme` has them; the volume is
// that of `stone` under every scheme.
MassProperties clump_mass_properties(const MassProperties& stone,
                                     const std::vector<Sphere>& spheres, MassScheme scheme);

// "uniform", "equal-mass" or "mesh". Throws InputError for other names.
MassScheme mass_scheme(const std::string& name);
} // namespace interlock::dem
