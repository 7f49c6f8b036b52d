// Inertia force and torque of a node that turns, and their derivative.
#pragma once

#include "fem/implicit/generalised_alpha.h"
#include "fem/lattice/lumped_inertia.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace interlock::fem
{
// Motion of a node at the end of a step: orientation exp(turn) start (from the unloaded state),
// with the rotation vector `turn` [rad] in the world frame.
struct NodeStep {
  Eigen::Quaterniond start;
  Eigen::Vector3d turn;
  Rates translation; // world
  Rates rotation;    // frame of the node, which is the world frame in the unloaded state
};

// Force m a and torque R (J w' + w x J w) in the world frame [N, N m]: what it takes to move the
// node so.
Eigen::Matrix<double, 6, 1> inertia_force(const NodeInertia& inertia, const NodeStep& step);

// Derivative of `inertia_force` by displacement and `turn`, when the rates follow both by `rule`.
// Not symmetric: the torque is gyroscopic, and rotations do not commute.
Eigen::Matrix<double, 6, 6> inertia_tangent(const NodeInertia& inertia, const NodeStep& step,
                                            const GeneralisedAlpha& rule);
} // namespace interlock::fem
