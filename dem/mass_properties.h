// Mass properties of a closed surface, by the divergence theorem, and of sets of spheres.
#pragma once

#include "dem/triangle_mesh.h"

namespace interlock::dem
{
// Of a body of unit density; multiply volume by the density [kg/m3] for the mass, inertia likewise.
struct MassProperties {
  double volume = 0;                          // [m3]
  Vector3 centre = Vector3::Zero();           // centre of volume, frame of the input [m]
  Matrix3 inertia = Matrix3::Zero();          // about `centre`, axes of the input, unit density [m5]
};

// Exact for the polyhedron. Negative volume means that the surface is inside out. Source: signed
// tetrahedra, e.g. Mirtich, J. Graphics Tools 1(2) (1996).
MassProperties mass_properties(const TriangleMesh& mesh);
} // namespace interlock::dem
