// A rotational spring between two rib lines that share a junction.
#pragma once

#include "fem/beam/beam_tangent.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace interlock::fem
{
// How stiffly lines are joined at a junction, the same for every pair of lines [N m/rad]: zero is a
// pin, infinity rigid. Displacements are always shared.
struct JunctionStiffness {
  double in_plane = INFINITY;     // about the normal of the lattice
  double out_of_plane = INFINITY; // about every axis in its plane: bending and twist
};

inline bool is_rigid(const JunctionStiffness& stiffness)
{
  return std::isinf(stiffness.in_plane) && std::isinf(stiffness.out_of_plane);
}

// Energy (in_plane (theta . n)^2 + out_of_plane |theta - (theta . n) n|^2)/2 [J] with the relative
// rotation vector theta = log(q1* q2) of the rotations q1, q2 of both nodes from the unloaded
// state, and the normal n of the unloaded plane; superposed rotation leaves it unchanged. That is
// the bending energy of a beam element of unit length without force stiffness, so the element's
// kernel does the work; its range of rotation applies.
struct RotationalSpring {
  std::array<int, 2> node{};       // of the lattice, both at the same place
  Eigen::Vector3d normal{0, 0, 1}; // unit, world, unloaded state
  double in_plane = 0;             // finite [N m/rad]
  double out_of_plane = 0;         // finite [N m/rad]
};

// Freedoms in the order rotation of the first node, of the second, world frame.
struct SpringTangent {
  Eigen::Matrix<double, 6, 1> moment;    // gradient of the energy by spin [N m]
  Eigen::Matrix<double, 6, 6> stiffness; // derivative of `moment` by the rotation vectors
};

// As beam_tangent: the rotation of node i is exp(turn[i]) * orientation[i].
SpringTangent spring_tangent(const RotationalSpring& spring,
                             const std::array<Eigen::Quaterniond, 2>& orientation,
                             const std::array<Eigen::Vector3d, 2>& turn);

// Moment that the spring exerts on the first node, world [N m]; the second takes its opposite.
Eigen::Vector3d spring_moment(const RotationalSpring& spring,
                              const std::array<Eigen::Quaterniond, 2>& orientation);

// Energy of the spring [J].
double spring_energy(const RotationalSpring& spring,
                     const std::array<Eigen::Quaterniond, 2>& orientation);
} // namespace interlock::fem
