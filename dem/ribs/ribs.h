// Ribs: moving convex rods that stones touch. dem knows their motion and returns contact wrenches;
// what makes them move (beams, a rigid frame) is not its business.
//
// A rib is a segment swept by a rounded rectangle: a flat core of half sizes (half_width -
// rounding) and (half_thickness - rounding) around the centre line, grown by `rounding`. A capsule
// is the special case in which both half sizes equal the rounding.
#pragma once

#include "dem/vector.h"

namespace interlock::dem
{
// One rod, from end 1 to end 2. World frame. Rods of the same `line` follow one another without a
// gap; a sphere has at most one contact with a line, on the rod that it overlaps most.
struct Rib {
  int line = 0;
  double half_width = 0, half_thickness = 0, rounding = 0; // [m]
  double inverse_mass[2] = {0, 0}; // of the rib at its ends, 0 when its motion is prescribed [1/kg]

  Vector3 x[2];                                      // ends of the centre line [m]
  Vector3 v[2] = {Vector3::Zero(), Vector3::Zero()}; // [m/s]
  Vector3 w[2] = {Vector3::Zero(), Vector3::Zero()}; // spin of the section [rad/s]
  Vector3 width_axis[2]; // of the section at the ends, unit, about normal to the centre line
};

// What a stone does to a rib.
struct RibWrench {
  int rib = 0;
  double xi = 0;  // place along the rod, 0 at end 1, 1 at end 2
  Vector3 force;  // on the rib, world [N]
  Vector3 moment; // about the point of the centre line at xi, world [N m]
};

// The wrench as loads on both ends of the rod, world frame: dual to the motion of the rod at xi, so
// the power is the same, and forces and moments balance. The rod turns with its chord, and about
// the chord with the width axis, interpolated between the ends and made perpendicular to the chord
// (rod_lanes.h).
struct RodLoads {
  int rib = 0;
  Vector3 force[2];  // [N]
  Vector3 moment[2]; // about the ends [N m]
};
RodLoads rod_loads(const Rib& rib, const RibWrench& wrench);

// Signed geometry of a sphere against one rod.
struct RibProximity {
  double distance; // from the sphere's centre to the core [m]
  double overlap;  // sphere radius + rounding - distance; negative: gap [m]
  double xi;       // of the nearest point of the centre line
  Vector3 core;    // nearest point of the core, world [m]
  Vector3 centre;  // nearest point of the centre line, world [m]
  Vector3 normal;  // unit, from the rib to the sphere
  // Where the section turns along the rod, the overlap changes along it too: minus its gradient by
  // the sphere's centre is normal + lean.
  Vector3 lean;
};
RibProximity rib_proximity(const Rib& rib, const Vector3& sphere_centre, double sphere_radius);

// Whether a sphere is certainly too far from the centre line to touch the rod: a quick test that
// saves most calls of rib_proximity. Without a root or a division.
inline bool clear_of(const Rib& rib, const Vector3& centre, double radius)
{
  const Vector3 chord = rib.x[1] - rib.x[0], d = centre - rib.x[0];
  const double along = chord.dot(d), square = chord.squaredNorm();
  const double reach = radius + rib.half_width + rib.half_thickness;
  if (along < 0) return d.squaredNorm() > reach * reach;
  if (along > square) return (centre - rib.x[1]).squaredNorm() > reach * reach;
  return d.squaredNorm() * square - along * along > reach * reach * square;
}

} // namespace interlock::dem
