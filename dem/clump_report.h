// How well a set of spheres stands for the stone that it was made from.
#pragma once

#include "dem/clump_shape.h"
#include "dem/triangle_mesh.h"

#include <array>

namespace interlock::dem
{
// Against the closed mesh (all relative, except where a unit is given).
struct ClumpReport {
  int nodes = 0;      // of the mesh
  int nodes_used = 0; // a ball was grown there, kept or rejected
  int rejected = 0;   // balls smaller than r_min
  // Per scheme (indexed by MassScheme): error of the principal moments (mean of the three absolute
  // relative errors), after scaling the mass to that of the mesh; offset of the centre [m].
  std::array<double, 3> inertia_error{};
  std::array<double, 3> centre_offset{};
  // From the mesh nodes to the union of the spheres; a node inside a sphere counts its depth [m].
  double surface_distance_mean = 0; // [m]
  double surface_distance_95 = 0;   // 95 % of the nodes are nearer [m]
  double surface_distance_max = 0;  // [m]
  double volume_error = 0;          // (union of the spheres - mesh)/mesh
};

// Fills the distances and the volume error; `spheres` in the frame of the mesh, at least one.
void measure_surface(const TriangleMesh& stone, const std::vector<Sphere>& spheres,
                     ClumpReport& report);

// Volume of the union of spheres [m3], to about 0.1 %: exact along `lines` x `lines` parallel rays.
double union_volume(const std::vector<Sphere>& spheres, int lines = 100);
} // namespace interlock::dem
