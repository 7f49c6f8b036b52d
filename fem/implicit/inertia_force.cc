#include "fem/implicit/inertia_force.h"

#include "fem/beam/beam_tangent.h"

#include <cmath>

namespace interlock::fem
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& v)
{
  Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

// T with exp(turn + d) = exp(T d) exp(turn) to first order.
Matrix3d exponential_tangent(const Vector3d& turn)
{
  const double square = turn.squaredNorm(), angle = std::sqrt(square);
  // Series where cancellation would cost digits; the next terms are below 1e-16.
  const bool small = square < 1e-4;
  const double a = small ? 0.5 - square * (1. / 24 - square / 720) : (1 - std::cos(angle)) / square;
  const double b = small ? 1. / 6 - square * (1. / 120 - square / 5040)
                         : (angle - std::sin(angle)) / (square * angle);
  const Matrix3d c = cross_matrix(turn);
  return Matrix3d::Identity() + a * c + b * c * c;
}

// J w' + w x J w in the frame of the node [N m].
Vector3d euler_torque(const NodeInertia& inertia, const Rates& rotation)
{
  return inertia.tensor * rotation.acceleration +
         rotation.velocity.cross(inertia.tensor * rotation.velocity);
}
} // namespace

Eigen::Matrix<double, 6, 1> inertia_force(const NodeInertia& inertia, const NodeStep& step)
{
  Eigen::Matrix<double, 6, 1> force;
  force << inertia.mass * step.translation.acceleration,
      rotation_exponential(step.turn) * (step.start * euler_torque(inertia, step.rotation));
  return force;
}

Eigen::Matrix<double, 6, 6> inertia_tangent(const NodeInertia& inertia, const NodeStep& step,
                                            const GeneralisedAlpha& rule)
{
  const Matrix3d& tensor = inertia.tensor;
  const Vector3d& spin = step.rotation.velocity;
  const Matrix3d start = step.start.toRotationMatrix();
  const Matrix3d end = rotation_exponential(step.turn).toRotationMatrix() * start;
  const Matrix3d in_body =
      rule.acceleration_slope() * tensor +
      rule.velocity_slope() * (cross_matrix(spin) * tensor - cross_matrix(tensor * spin));
  const Vector3d torque = end * euler_torque(inertia, step.rotation);

  Eigen::Matrix<double, 6, 6> tangent = Eigen::Matrix<double, 6, 6>::Zero();
  tangent.topLeftCorner<3, 3>().diagonal().setConstant(rule.acceleration_slope() * inertia.mass);
  tangent.bottomRightCorner<3, 3>() =
      end * in_body * start.transpose() - cross_matrix(torque) * exponential_tangent(step.turn);
  return tangent;
}
} // namespace interlock::fem
