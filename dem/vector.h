// Short names for the small algebra of the DEM module. World and body vectors share these types;
// every function says which frame it wants.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace interlock::dem
{
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond; // unit, body to world: X_world = q * x_body + position
} // namespace interlock::dem
