// Mass properties of a closed surface, by the divergence theorem, and of sets of spheres.
#pragma once

#include "dem/bodies/clump_shape.h"
#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// Of a body of unit density; multiply volume by the density [kg/m3] for the mass, inertia likewise.
struct MassProperties {
  double volume = 0;                 // [m3]
  Vector3 centre = Vector3::Zero();  // centre of volume, frame of the input [m]
  Matrix3 inertia = Matrix3::Zero(); // about `centre`, axes of the input, unit density [m5]
};

// Exact for the polyhedron. Negative volume means that the surface is inside out. Source: signed
// tetrahedra, e.g. Mirtich, J. Graphics Tools 1(2) (1996).
MassProperties mass_properties(const TriangleMesh& mesh);

// Of solid spheres that may overlap: what overlaps counts twice. volumes[i] is the mass of sphere i
// in units of density [m3]; it need not be that of the ball, see MassScheme in clump_generator.h.
// Source: 2/5 m r^2 and the parallel-axis theorem.
MassProperties mass_properties(const std::vector<Sphere>& spheres,
                               const std::vector<double>& volumes);

// Principal moments in ascending order [m5], and the rotation whose columns are their axes:
// X_input = axes * x_principal. Right-handed; of the first two axes the largest component is
// positive, so that equal input gives equal axes. Where moments coincide the choice within them is
// arbitrary.
struct PrincipalFrame {
  Vector3 moments;
  Matrix3 axes;
};
PrincipalFrame principal_frame(const MassProperties& properties);
} // namespace interlock::dem
