// Geometrically exact (Simo-Reissner) beam element with three nodes, straight or curved.
//
// Interpolation of rotations: Crisfield & Jelenic, Proc. R. Soc. A 455 (1999) 1125-1147, sections 4
// and 5. The reference frame is that of the middle node, L2; psi_i = log(L2^T L_i) are the local
// rotation vectors of the nodes, and L(s) = L2 exp(psi), psi = sum of I_i psi_i with the quadratic
// shape functions I_i. Positions are quadratic. Strains, in the section's frame L(s),
//   force strains  L^T x' - L0^T x0'  (stretch along e1, shears along e2, e3)
//   curvatures     axial vector of L^T L' less that of the unloaded element
// do not change under rigid motion and vanish in the unloaded state, whatever its curve. Two Gauss
// points (reduced integration: no locking, and twelve strains leave six rigid modes).
//
// The strain energy is the only formula; forces are its gradient and the stiffness is its second
// derivative, both by automatic differentiation. Linear elastic: BeamSection's softening and yield
// force are refused.
#pragma once

#include "fem/beam/section_forces.h"
#include "fem/ribs/beam_section.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>

namespace interlock::fem
{
// Nodes in order along the beam: first end, middle, second end.
using NodePositions = std::array<Eigen::Vector3d, 3>; // world [m]
using NodeOrientations =
    std::array<Eigen::Quaterniond, 3>; // unit, rotation from the unloaded state
using QuadraticForce = Eigen::Matrix<double, 18, 1>;

struct QuadraticBeam {
  struct GaussPoint {
    double weight;                      // length that it stands for [m]
    std::array<double, 3> shape;        // I_i [-]
    std::array<double, 3> slope;        // dI_i/ds by length of the unloaded curve [1/m]
    Eigen::Vector3d unloaded_tangent;   // L0^T x0' [-]
    Eigen::Vector3d unloaded_curvature; // [1/m]
  };
  std::array<Eigen::Quaterniond, 3> frame; // section frames of the unloaded nodes, to world
  std::array<double, 3> force_stiffness;   // axial, shear along e2, along e3 [N]
  std::array<double, 3> moment_stiffness;  // torsion, bending about e2, about e3 [N m2]
  std::array<GaussPoint, 2> points;
};

// An element through three unloaded points [m] with the section frame of each node: e1 along the
// curve, e2, e3 as in BeamSection.
// Throws std::invalid_argument when two points coincide, when the middle node is so far off the
// middle that the curve folds back, or when the section softens or yields.
QuadraticBeam quadratic_beam(const NodePositions& position,
                             const std::array<Eigen::Quaterniond, 3>& frame,
                             const BeamSection& section);

// Section frames at three points: e1 along the parabola through them, e3 nearest to `normal`.
// Throws std::invalid_argument when the normal points along the curve.
std::array<Eigen::Quaterniond, 3> curve_frames(const NodePositions& position,
                                               const Eigen::Vector3d& normal);

// Strain energy [J].
double strain_energy(const QuadraticBeam& beam, const NodePositions& position,
                     const NodeOrientations& orientation);

// Gradient of the strain energy by displacement and spin of the first, middle and last node, six
// each, world frame [N, N m].
QuadraticForce beam_force(const QuadraticBeam& beam, const NodePositions& position,
                          const NodeOrientations& orientation);

// Section forces at both Gauss points, in the section's frame there.
std::array<SectionForces, 2> section_forces(const QuadraticBeam& beam,
                                            const NodePositions& position,
                                            const NodeOrientations& orientation);

// As BeamTangent: the rotation of node i is exp(turn[i]) * orientation[i]; `stiffness` is the
// derivative of `force` by displacement and rotation vector, symmetric where the element's nodal
// moments and `turn` are zero.
struct QuadraticTangent {
  QuadraticForce force;
  Eigen::Matrix<double, 18, 18> stiffness;
};
QuadraticTangent beam_tangent(const QuadraticBeam& beam, const NodePositions& position,
                              const NodeOrientations& orientation, const NodePositions& turn);
} // namespace interlock::fem
