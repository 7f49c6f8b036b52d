// One step of the attitude of a free rigid body, written for vector lanes.
#pragma once

#include "dem/lane_vector.h"

namespace interlock::dem
{
// World spin of a body with this angular momentum (world) and inverse principal moments [rad/s].
INTERLOCK_LANE Lane3 spin_from_momentum(LaneQuaternion q, Lane3 momentum, Lane3 inverse_inertia)
{
  const Lane3 body = rotate(conjugate(q), momentum);
  return rotate(
      q, {inverse_inertia.x * body.x, inverse_inertia.y * body.y, inverse_inertia.z * body.z});
}

// Quaternion of the rotation vector 2 `half` (world axes). Series instead of library functions,
// without a branch: exact to rounding up to |half| = 0.2, wrong by 1e-12 at 0.5 and 2e-9 at 1.
INTERLOCK_LANE LaneQuaternion rotation_step(Lane3 half)
{
  const double h2 = dot(half, half);
  const double sinc =
      1 + h2 * (-1. / 6 +
                h2 * (1. / 120 + h2 * (-1. / 5040 + h2 * (1. / 362880 + h2 * (-1. / 39916800)))));
  const double cosine =
      1 +
      h2 * (-1. / 2 + h2 * (1. / 24 + h2 * (-1. / 720 + h2 * (1. / 40320 + h2 * (-1. / 3628800)))));
  return {sinc * half.x, sinc * half.y, sinc * half.z, cosine};
}

struct AttitudeStep {
  LaneQuaternion attitude; // at the end of the step
  Lane3 spin;              // in the middle of the step, world [rad/s]
};

// Midpoint step of the free asymmetric body over `dt` [s]: half a step to find the spin there, then
// a full step with it. Second order; `momentum` (world) is constant and needs no gyroscopic term.
INTERLOCK_LANE AttitudeStep advance_attitude(LaneQuaternion q, Lane3 momentum,
                                             Lane3 inverse_inertia, double dt)
{
  const Lane3 start = spin_from_momentum(q, momentum, inverse_inertia);
  const LaneQuaternion ahead = rotation_step(0.25 * dt * start) * q;
  const Lane3 spin = spin_from_momentum(ahead, momentum, inverse_inertia);
  LaneQuaternion end = rotation_step(0.5 * dt * spin) * q;
  // One Newton step of 1/sqrt: the norm is 1 up to rounding already.
  const double scale = 1.5 - 0.5 * (end.x * end.x + end.y * end.y + end.z * end.z + end.w * end.w);
  end = {scale * end.x, scale * end.y, scale * end.z, scale * end.w};
  return {end, spin};
}
} // namespace interlock::dem
