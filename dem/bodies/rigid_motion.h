// One step of the attitude of a free rigid body, written for vector lanes.
#pragma once

#include "dem/lane_vector.h"

namespace interlock::dem
{
// World spin of a body with this angular momentum (world) and inverse principal moments [rad/s].
template <class Number>
INTERLOCK_LANE LaneVector<Number> spin_from_momentum(LaneQuaternionOf<Number> q,
                                                     LaneVector<Number> momentum,
                                                     LaneVector<Number> inverse_inertia)
{
  return rotate(q, componentwise(inverse_inertia, rotate(conjugate(q), momentum)));
}

// Quaternion of the rotation vector 2 `half`: a factor on the left for world axes, on the right for
// axes of the body. Series instead of library functions,
// without a branch: exact to rounding up to |half| = 0.2, wrong by 1e-12 at 0.5 and 2e-9 at 1.
template <class Number>
INTERLOCK_LANE LaneQuaternionOf<Number> rotation_step(LaneVector<Number> half)
{
  const Number h2 = dot(half, half);
  const Number sinc =
      1 + h2 * (-1. / 6 +
                h2 * (1. / 120 + h2 * (-1. / 5040 + h2 * (1. / 362880 + h2 * (-1. / 39916800)))));
  const Number cosine =
      1 +
      h2 * (-1. / 2 + h2 * (1. / 24 + h2 * (-1. / 720 + h2 * (1. / 40320 + h2 * (-1. / 3628800)))));
  return {sinc * half.x, sinc * half.y, sinc * half.z, cosine};
}

template <class Number> struct AttitudeStep {
  LaneQuaternionOf<Number> attitude; // at the end of the step
  LaneVector<Number> spin;           // in the middle of the step, world [rad/s]
};

// Midpoint step of the free asymmetric body over `dt` [s]: half a step to find the spin there,
// about axes of the body, then a full step with it. Second order; `momentum` (world) is constant
// and needs no gyroscopic term.
template <class Number>
INTERLOCK_LANE AttitudeStep<Number> advance_attitude(LaneQuaternionOf<Number> q,
                                                     LaneVector<Number> momentum,
                                                     LaneVector<Number> inverse_inertia, double dt)
{
  const LaneVector<Number> start = componentwise(inverse_inertia, rotate(conjugate(q), momentum));
  const LaneQuaternionOf<Number> ahead = q * rotation_step(0.25 * dt * start);
  const LaneVector<Number> spin = spin_from_momentum(ahead, momentum, inverse_inertia);
  const LaneQuaternionOf<Number> end = rotation_step(0.5 * dt * spin) * q;
  // One Newton step of 1/sqrt: the norm is 1 up to rounding already.
  const Number scale = 1.5 - 0.5 * (end.x * end.x + end.y * end.y + end.z * end.z + end.w * end.w);
  return {{scale * end.x, scale * end.y, scale * end.z, scale * end.w}, spin};
}
} // namespace interlock::dem
