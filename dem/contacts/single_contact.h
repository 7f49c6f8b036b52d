// The contact law for one contact at a time, with Eigen's vectors: for walls of triangles.
#pragma once

#include "dem/contacts/contact_law.h"
#include "dem/vector.h"

#include <cmath>

namespace interlock::dem
{
// Turns the tangential spring with the contact: by `turn` (mean spin of the two bodies times the
// step) [rad], then out of its plane into the one normal to `normal`, keeping its length.
inline void rotate_spring(Vector3& spring, const Vector3& normal, const Vector3& turn)
{
  const double old_length_squared = spring.squaredNorm();
  if (old_length_squared == 0) return;
  spring += turn.cross(spring).eval();
  spring -= normal.dot(spring) * normal;
  const double length_squared = spring.squaredNorm();
  if (length_squared > 0) spring *= std::sqrt(old_length_squared / length_squared);
}

// contact_force() of the linear model for an `overlap` > 0; history.spring must have been turned by
// rotate_spring().
INTERLOCK_LANE Vector3 linear_contact_force(const ContactProperties& pair, double reduced_mass,
                                            double overlap, const Vector3& normal,
                                            const Vector3& relative_velocity, double time_step,
                                            ContactHistory& history, ContactEnergy& energy)
{
  LaneHistory h{lane(history.spring), lane(history.dashpot), history.overlap,
                pair.tangential_stiffness};
  LaneEnergy e;
  const Lane3 force = contact_force<false>(
      LinearLaw(pair), {reduced_mass, std::sqrt(reduced_mass), 0}, overlap, lane(normal),
      lane(relative_velocity), Lane3{0, 0, 0}, {}, time_step, h, e);
  history = {vector(h.spring), h.overlap, vector(h.dashpot)};
  energy.elastic += e.elastic;
  energy.friction += e.friction;
  energy.damping += e.damping;
  return vector(force);
}

// Ends a contact that has opened by `gap` [m].
inline void end_contact(const ContactProperties& pair, double gap, const Vector3& relative_velocity,
                        double time_step, ContactHistory& history, ContactEnergy& energy)
{
  const double touching = history.overlap / (history.overlap + gap);
  energy.damping += 0.5 * touching * time_step * history.dashpot.dot(relative_velocity);
  energy.friction += 0.5 * pair.tangential_stiffness * history.spring.squaredNorm();
  history = ContactHistory();
}
} // namespace interlock::dem
