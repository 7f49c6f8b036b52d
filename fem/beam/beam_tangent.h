// Internal force vector of a beam element and its exact derivative, by automatic differentiation.
#pragma once

#include "fem/beam/beam_element.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>

namespace interlock::fem
{
// Freedoms in the order displacement and rotation of the first node, then of the second, world
// frame.
struct BeamTangent {
  Eigen::Matrix<double, 12, 1>
      force; // gradient of the strain energy by displacement and spin [N, N m]
  Eigen::Matrix<double, 12, 12>
      stiffness; // derivative of `force` by displacement and rotation vector
};

// The rotation of node i is exp(turn[i]) * orientation[i]: a rotation vector [rad] on top of a
// given unit quaternion, so that a solver can hold plain vectors while rotations stay
// multiplicative. The stiffness is symmetric only where the element is in equilibrium and `turn` is
// zero.
BeamTangent beam_tangent(const BeamConstants<double>& beam,
                         const std::array<Eigen::Vector3d, 2>& position,
                         const std::array<Eigen::Quaterniond, 2>& orientation,
                         const std::array<Eigen::Vector3d, 2>& turn);

// The same force without its derivative.
Eigen::Matrix<double, 12, 1> beam_force(const BeamConstants<double>& beam,
                                        const std::array<Eigen::Vector3d, 2>& position,
                                        const std::array<Eigen::Quaterniond, 2>& orientation);

// Unit quaternion of a rotation vector [rad], any length.
Eigen::Quaterniond rotation_exponential(const Eigen::Vector3d& turn);
} // namespace interlock::fem
