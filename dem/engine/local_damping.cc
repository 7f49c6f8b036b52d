#include "dem/engine/local_damping.h"

#include "dem/bodies/field_rows.h"
#include "dem/bodies/rigid_motion.h"

#include <cmath>

namespace interlock::dem
{
namespace
{
// |size| with the sign of `direction`, 0 where that is 0.
INTERLOCK_LANE double along(double size, double direction)
{
  double sign = direction > 0 ? 1 : 0;
  sign = direction < 0 ? -1 : sign;
  return sign * std::abs(size);
}

INTERLOCK_LANE Lane3 along(Lane3 size, Lane3 direction)
{
  return {along(size.x, direction.x), along(size.y, direction.y), along(size.z, direction.z)};
}
} // namespace

void LocalDamping::damp(Clumps& clumps, double gravity, double dt, const VectorField* other_force,
                        const VectorField* other_torque)
{
  nothing_.resize(clumps.size());
  const Rows3<double> force(clumps.force), torque(clumps.torque);
  const Rows3<const double> more_force(other_force ? *other_force : nothing_),
      more_torque(other_torque ? *other_torque : nothing_);
  const Rows3<const double> velocity(clumps.velocity), spin(clumps.spin),
      momentum(clumps.angular_momentum), inverse_inertia(clumps.inverse_inertia);
  const double* __restrict mass = clumps.mass.row(0);
  const double* __restrict inverse_mass = clumps.inverse_mass.row(0);
  const QuaternionRows<const double> attitude(clumps.orientation);
  double* __restrict lost = clumps.lost.row(Clumps::to_local_damping);
  const double wanted = share;
  const int n = clumps.force.padded_size();
#pragma GCC ivdep
  for (std::int64_t i = 0; i < n; ++i) {
    Lane3 f = force.get(i), t = torque.get(i);
    Lane3 unbalanced = f + more_force.get(i);
    const double size = std::abs(unbalanced.x) + std::abs(unbalanced.y) + std::abs(unbalanced.z);
    const double part = size > 0 ? wanted : 0; // a clump that touches nothing falls freely
    unbalanced.z -= mass[i] * gravity;
    const Lane3 v = velocity.get(i), w = spin.get(i);
    const Lane3 damping = part * along(unbalanced, v);
    const Lane3 turning = part * along(t + more_torque.get(i), w);
    f = f - damping;
    t = t - turning;
    force.set(i, f);
    torque.set(i, t);
    Lane3 mean_v = v + 0.5 * dt * inverse_mass[i] * f;
    mean_v.z -= 0.5 * dt * gravity;
    const Lane3 mean_w =
        spin_from_momentum(attitude.get(i), momentum.get(i) + 0.5 * dt * t, inverse_inertia.get(i));
    lost[i] += dt * (dot(damping, mean_v) + dot(turning, mean_w));
  }
}
} // namespace interlock::dem
