// Walls that press with a given force along an axis: surcharge plates, triaxial walls. The idea of
// a gain from the stiffness of the contacts is that of servo-controlled walls in Itasca's PFC
// manual; law and stability: docs/theory/walls.md.
//
// Sign: the axis points from the wall into the stones. Forces are positive when the wall presses
// the stones along it, speeds when the wall moves along it.
#pragma once

#include "dem/contacts/contact_views.h"
#include "dem/walls/mesh_contacts.h"
#include "dem/walls/wall.h"

namespace interlock::dem
{
struct ForceControl {
  Vector3 axis = Vector3::UnitZ(); // unit, world
  double force = 0;                // to be kept, 0 or more: walls do not pull [N]
  double largest_speed = 0;        // either way [m/s]
  // Share of the error that one step takes away, alpha [-]. Without dashpots a step is stable when
  // it is so with the stiffness of the wall's contacts divided by (1 - gain/2), however many they
  // are; with them see docs/theory/walls.md.
  double gain = 0.5;
  // State: speed of stones that move steadily, learnt so that they feel the whole force too [m/s].
  double followed_speed = 0;
};

// Throws InputError with one sentence when the axis is not a unit vector, the force is negative or
// not finite, the speed not above 0, or the gain not above 0 and at most 0.8.
void check(const ForceControl& control);

// Speed along the axis for the next step [m/s]:
//     clamp(followed_speed + gain (F* - F)/R, -largest_speed, largest_speed)
// and with nothing in touch (R = 0) the largest speed towards the stones, or 0 if F* is 0.
// `pressing_force` F: of the wall on the stones along the axis, now [N]; `response` R: a bound of
// how much F changes in one step for a unit of speed [N s/m].
double controlled_speed(const ForceControl& control, double pressing_force, double response);

// R of one wall with these contacts: the sum of k dt + 2 zeta sqrt(k m) over those that touch, k
// being the larger of normal and tangential stiffness, zeta the damping ratio, m the clump's mass.
// `pair`: the wall's properties; `time_step` [s].
double contact_response(const std::vector<WallContact>& contacts, int wall,
                        const ContactProperties& pair, const Clumps& clumps, double time_step);
double contact_response(const std::vector<MeshContact>& contacts, int wall,
                        const ContactProperties& pair, const Clumps& clumps, double time_step);

// Sets the wall's velocity along the axis from its present force; across the axis it is left as it
// is. Learns the followed speed, at a hundredth of gain (F* - F)/R a step, while that is not
// clamped; forgets it when nothing is in touch. To be called each step after the contacts were
// evaluated and before the wall moves, so that the contacts always see the velocity of the last
// move.
void control_force(ForceControl& control, double response, Wall& wall);
void control_force(ForceControl& control, double response, MeshWall& wall);

template <class Archive> void exchange(Archive& archive, ForceControl& control)
{
  archive("axis", control.axis);
  archive("force", control.force, "N");
  archive("largest_speed", control.largest_speed, "m/s");
  archive("gain", control.gain);
  archive("followed_speed", control.followed_speed, "m/s");
}
} // namespace interlock::dem
