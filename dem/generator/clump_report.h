// How well a set of spheres stands for the stone that it was made from.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/meshes/mass_properties.h"

#include <array>

namespace interlock::dem
{
enum class MassScheme {
  uniform,    // the same density in every sphere
  equal_mass, // the same mass in every sphere: the correction of the paper
  mesh        // volume, centre and inertia of the closed surface
};

// Why the generator stopped.
enum class Stop { all_nodes, no_gain, p_max, max_spheres, volume_error, inertia_error };

// Against the closed surface (all relative, except where a unit is given).
struct ClumpReport {
  int nodes = 0;      // of the surface
  int nodes_used = 0; // a ball was grown there, kept or rejected; in the order by gain: kept
  int rejected = 0;   // balls smaller than r_min
  double bulge = 0;   // by which each sphere was made larger [m]
  Stop stop = Stop::all_nodes;
  // Per scheme (indexed by MassScheme), after scaling the mass to that of the stone: error of the
  // principal moments (mean of the three absolute relative errors), largest angle between principal
  // axes that belong together [degrees], offset of the centre [m].
  std::array<double, 3> inertia_error{};
  std::array<double, 3> axis_error{};
  std::array<double, 3> centre_offset{};
  // False when two moments of the stone differ by less than 5 %: its axes, and so axis_error, then
  // mean little.
  bool axes_are_distinct = true;
  // From the nodes to the union of the spheres; a node inside a sphere counts its depth [m].
  double surface_distance_mean = 0; // [m]
  double surface_distance_95 = 0;   // 95 % of the nodes are nearer [m]
  double surface_distance_max = 0;  // [m]
  double volume_error = 0;          // (union of the spheres - stone)/stone
  double volume_uncertainty = 0;    // of volume_error, from the sampling (union_volume.h)
  int groups = 0;                   // of spheres that hang together (sphere_groups.h)
  // The body frame of the clump in the frame of the surface: x_surface = origin + rotation x_body.
  Vector3 origin = Vector3::Zero(); // [m]
  Quaternion rotation = Quaternion::Identity();
};

// Mass properties of the spheres, in the frame of the surface, as `scheme` has them; the volume is
// that of `stone` under every scheme.
MassProperties clump_mass_properties(const MassProperties& stone,
                                     const std::vector<Sphere>& spheres, MassScheme scheme);

// Mean of the three absolute relative errors of the principal moments.
double inertia_error(const MassProperties& value, const MassProperties& exact);

// Fills all errors of `report`; `nodes` and `spheres` (at least one) in the frame of the surface
// that `stone` belongs to.
void measure_errors(const std::vector<Vector3>& nodes, const MassProperties& stone,
                    const std::vector<Sphere>& spheres, ClumpReport& report);
} // namespace interlock::dem
