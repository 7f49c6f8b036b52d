// The derivative of a node's inertia force against central differences, for large turns and small
// ones, and the torque against the change of angular momentum. Fails when a gyroscopic term or the
// tangent of the exponential is wrong.
#include "fem/beam/beam_tangent.h"
#include "fem/implicit/inertia_force.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace interlock::fem;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Increment = Eigen::Matrix<double, 6, 1>;

std::mt19937 generator(3);

Vector3d random_vector(double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

Rates random_rates()
{
  return {random_vector(3), random_vector(20), random_vector(20)};
}

NodeInertia some_inertia()
{
  NodeInertia inertia;
  inertia.mass = 0.7;
  inertia.tensor << 0.5, 0.1, -0.05, 0.1, 0.3, 0.02, -0.05, 0.02, 0.2;
  return inertia;
}

struct Start {
  Quaterniond orientation;
  Rates translation, rotation;
};

NodeStep node_step(const Start& start, const GeneralisedAlpha& rule, const Increment& increment)
{
  const Vector3d move = increment.head<3>(), turn = increment.tail<3>();
  return {start.orientation, turn, advanced(rule, start.translation, move),
          advanced(rule, start.rotation, start.orientation.conjugate() * turn)};
}

TEST(InertiaForce, TangentIsItsDerivative)
{
  const NodeInertia inertia = some_inertia();
  for (const double size : {1e-9, 4e-3, 0.5, 1.5}) {
    const Start start{rotation_exponential(random_vector(2)), random_rates(), random_rates()};
    const GeneralisedAlpha rule(0.7, 0.1);
    Increment here;
    here << random_vector(0.1), random_vector(size);
    const Eigen::Matrix<double, 6, 6> tangent =
        inertia_tangent(inertia, node_step(start, rule, here), rule);
    for (int c = 0; c < 6; ++c) {
      const Increment step = 1e-6 * Increment::Unit(c);
      const Increment slope = (inertia_force(inertia, node_step(start, rule, here + step)) -
                               inertia_force(inertia, node_step(start, rule, here - step))) /
                              2e-6;
      EXPECT_LT((tangent.col(c) - slope).norm(), 1e-7 * tangent.norm()) << size << " " << c;
    }
  }
}

// At constant rates over a short time: the torque is the change of R J w, in the world frame.
TEST(InertiaForce, TorqueIsTheChangeOfAngularMomentum)
{
  const NodeInertia inertia = some_inertia();
  const Quaterniond orientation = rotation_exponential(random_vector(2));
  const Vector3d spin = random_vector(2), acceleration = random_vector(5);
  const auto momentum = [&](double t) -> Vector3d {
    // Third order in t from the body-frame spin and its rate.
    const Quaterniond q = orientation * rotation_exponential(spin * t + 0.5 * t * t * acceleration);
    return q * (inertia.tensor * (spin + t * acceleration));
  };
  NodeStep step{orientation, Vector3d::Zero(), {}, {}};
  step.rotation.velocity = spin;
  step.rotation.acceleration = acceleration;
  const Vector3d torque = inertia_force(inertia, step).tail<3>();
  EXPECT_LT((torque - (momentum(1e-5) - momentum(-1e-5)) / 2e-5).norm(), 1e-8);
}
} // namespace
