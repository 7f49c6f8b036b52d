// The linear contact law with Coulomb friction: a pure function of one contact.
//
// Normal: spring and dashpot, no tension (the contact ends at zero force). Tangential: spring with
// history and dashpot, limited by the Coulomb cone; the spring turns with the contact. Springs of
// two bodies act in series (Ferellec and McDowell 2010, Table 6, read with the usual k = k1 k2 /
// (k1 + k2)).
#pragma once

#include "dem/vector.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
// Of one pair of materials.
struct ContactProperties {
  double normal_stiffness = 0;     // of the pair [N/m]
  double tangential_stiffness = 0; // [N/m]
  double friction = 0;             // Coulomb coefficient [-]
  double damping_ratio = 0;        // c / (2 sqrt(k m)), normal and tangential [-]
  // Besides: dashpots of this rate times the reduced mass [1/s].
  double normal_damping_rate = 0;
  double tangential_damping_rate = 0;
  // Convention for the end of an impact: at zero force (no tension, the default), or at zero
  // overlap, with tension in between. The same damping ratio gives different restitution (Schwager
  // and Poeschel, Granular Matter 9 (2007) 465-469).
  bool tension = false;
};

// Springs in series [N/m].
inline double series_stiffness(double k1, double k2)
{
  return k1 * k2 / (k1 + k2);
}

// Running sums over contacts and steps. `elastic` is the energy stored now; the others are
// dissipated since the beginning. [J]
struct ContactEnergy {
  double elastic = 0;
  double friction = 0;
  double damping = 0;
};

// Turns the tangential spring with the contact: out of its old plane into the plane normal to
// `normal`, keeping its length, and about the normal by `twist` (mean spin of the two bodies along
// the normal times the step) [rad].
inline void rotate_spring(Vector3& spring, const Vector3& normal, double twist)
{
  const double old_length_squared = spring.squaredNorm();
  if (old_length_squared == 0) return;
  spring -= normal.dot(spring) * normal;
  spring += twist * normal.cross(spring);
  const double length_squared = spring.squaredNorm();
  if (length_squared > 0) spring *= std::sqrt(old_length_squared / length_squared);
}

// What a contact remembers, world frame, of body 1 against body 2. Zero while the contact is open.
struct ContactHistory {
  Vector3 spring =
      Vector3::Zero(); // tangential displacement since it formed, less what slipped [m]
  double overlap = 0;  // [m]
  Vector3 dashpot = Vector3::Zero(); // dissipative part of the last force [N]
};

// Force on body 1, world frame [N]. `normal` points from body 2 to body 1; `relative_velocity` is
// that of body 1 against body 2 at the contact point, in the middle of the step that led here
// [m/s]; `overlap` > 0 [m]; `reduced_mass` scales the dashpots [kg]. history.spring must have been
// turned by rotate_spring(); the history is advanced over `time_step` [s].
//
// Energy: a leapfrog kick does the work of the mean of the forces at both ends of a step. So
// dashpots dissipate the mean of their old and new force times the relative motion, friction the
// mean spring force times the slip, and neither has an error of first order in the step.
// Always inlined: the call costs as much as the law.
[[gnu::always_inline]] inline Vector3
linear_contact_force(const ContactProperties& pair, double reduced_mass, double overlap,
                     const Vector3& normal, const Vector3& relative_velocity, double time_step,
                     ContactHistory& history, ContactEnergy& energy)
{
  const double k_n = pair.normal_stiffness, k_t = pair.tangential_stiffness;
  const double c_n = 2 * pair.damping_ratio * std::sqrt(k_n * reduced_mass) +
                     pair.normal_damping_rate * reduced_mass;
  const double c_t = 2 * pair.damping_ratio * std::sqrt(k_t * reduced_mass) +
                     pair.tangential_damping_rate * reduced_mass;

  const double v_n = relative_velocity.dot(normal);
  const double elastic_n = k_n * overlap;
  const double viscous_n = elastic_n - c_n * v_n;
  const double f_n = pair.tension ? viscous_n : std::max(0., viscous_n);
  Vector3 dashpot = (elastic_n - f_n) * normal;
  Vector3 force = f_n * normal;

  if (pair.friction > 0) {
    const Vector3 v_t = relative_velocity - v_n * normal;
    Vector3 dashpot_t = c_t * v_t;
    const Vector3 trial = history.spring + time_step * v_t;
    Vector3 spring = trial;
    Vector3 f_t = -k_t * trial - dashpot_t;
    const double limit = pair.friction * std::max(0., f_n), f_t_squared = f_t.squaredNorm();
    if (f_t_squared > limit * limit) {
      // Sliding: the whole force is friction, and the spring is what holds it.
      f_t *= limit / std::sqrt(f_t_squared);
      dashpot_t.setZero();
      spring = -f_t / k_t;
      energy.friction += 0.5 * k_t * (history.spring + spring).dot(trial - spring);
    }
    history.spring = spring;
    dashpot += dashpot_t;
    force += f_t;
  }

  energy.damping += 0.5 * time_step * (history.dashpot + dashpot).dot(relative_velocity);
  energy.elastic += 0.5 * elastic_n * overlap + 0.5 * k_t * history.spring.squaredNorm();
  history.dashpot = dashpot;
  history.overlap = overlap;
  return force;
}

// Ends a contact that has opened by `gap` [m]: its last dashpot force fades over the part of the
// step in which it still touched, and the little that the spring still holds is lost to friction.
inline void end_contact(const ContactProperties& pair, double gap, const Vector3& relative_velocity,
                        double time_step, ContactHistory& history, ContactEnergy& energy)
{
  const double touching = history.overlap / (history.overlap + gap);
  energy.damping += 0.5 * touching * time_step * history.dashpot.dot(relative_velocity);
  energy.friction += 0.5 * pair.tangential_stiffness * history.spring.squaredNorm();
  history = ContactHistory();
}
} // namespace interlock::dem
