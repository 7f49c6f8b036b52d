// A sphere against one rod, and the motion of a rod at a contact, as formulas for vector lanes: the
// only place where they stand. ribs.h offers them one at a time. World frame, SI units.
#pragma once

#include "dem/lane_vector.h"

#include <cmath>

namespace interlock::dem
{
// What the geometry of a rod is made of: ends 1 and 2 of its centre line and the width axes there,
// the half sizes of its flat core, and the rounding around it.
struct RodLane {
  Lane3 x1, x2, axis1, axis2;
  double core_width, core_thickness, rounding;
};

struct RodMotionLane {
  Lane3 v1, v2, w1, w2; // of the ends, spins of the sections there
};

// The fields of RibProximity, and the frame of the section at xi: e1 along the chord, e2 along the
// width, e3 across both.
struct RodNearest {
  double overlap, distance, xi;
  Lane3 centre, core, normal, lean;
  Lane3 chord, e1, e2, e3;
  double inverse_length; // of the chord
  double width_along;    // part of the width axis along the chord
  double inverse_across; // of the length of the width axis across the chord
};

INTERLOCK_LANE double clamped(double a, double low, double high)
{
  a = a > low ? a : low;
  return a < high ? a : high;
}

INTERLOCK_LANE RodNearest nearest_on_rod(const RodLane& rod, Lane3 sphere, double radius)
{
  RodNearest n;
  n.chord = rod.x2 - rod.x1;
  const double square = dot(n.chord, n.chord);
  n.inverse_length = 1 / std::sqrt(square);
  n.e1 = n.inverse_length * n.chord;
  n.xi = clamped(n.inverse_length * dot(n.e1, sphere - rod.x1), 0, 1);
  n.centre = rod.x1 + n.xi * n.chord;

  // Section axes, made perpendicular to the chord so that the nearest point is exact.
  const Lane3 turn = rod.axis2 - rod.axis1;
  const Lane3 width = rod.axis1 + n.xi * turn;
  n.width_along = dot(width, n.e1);
  const Lane3 across = width - n.width_along * n.e1;
  n.inverse_across = 1 / std::sqrt(dot(across, across));
  n.e2 = n.inverse_across * across;
  n.e3 = cross(n.e1, n.e2);
  const Lane3 d = sphere - n.centre;
  const double y = clamped(dot(d, n.e2), -rod.core_width, rod.core_width);
  const double z = clamped(dot(d, n.e3), -rod.core_thickness, rod.core_thickness);
  n.core = n.centre + y * n.e2 + z * n.e3;

  const Lane3 gap = sphere - n.core;
  n.distance = std::sqrt(dot(gap, gap) + 1e-300);
  n.overlap = (radius + rod.rounding) - n.distance;
  const bool outside = n.distance > 1e-12;
  const double inverse = 1 / n.distance;
  n.normal.x = outside ? inverse * gap.x : n.e3.x;
  n.normal.y = outside ? inverse * gap.y : n.e3.y;
  n.normal.z = outside ? inverse * gap.z : n.e3.z;

  // How fast the section turns along the rod [rad/m]; beyond its ends the nearest point stays.
  const double twist = n.inverse_across * n.inverse_length * dot(n.e3, turn);
  // Two selects: a condition of two parts keeps the compiler from using lanes.
  double twist_inside = n.xi > 0 ? twist : 0;
  twist_inside = n.xi < 1 ? twist_inside : 0;
  const double slope = twist_inside * (y * dot(n.normal, n.e3) - z * dot(n.normal, n.e2));
  n.lean = -slope * n.e1;
  return n;
}

// How the section at xi turns about the chord: e3 . d(e2). It has the spins of both ends in it,
// and, where sections lean along the chord, the turn of the chord.
struct RodTurning {
  Lane3 spin_share1, spin_share2; // of each end's spin [-]
  Lane3 chord_share;              // of the velocity of end 2 against end 1 [1/m]
};

INTERLOCK_LANE RodTurning turning_about_chord(const RodLane& rod, const RodNearest& n)
{
  return {(1 - n.xi) * n.inverse_across * cross(rod.axis1, n.e3),
          n.xi * n.inverse_across * cross(rod.axis2, n.e3),
          -n.width_along * n.inverse_across * n.inverse_length * n.e3};
}

// Spin of the rod at the nearest point [rad/s]: of the chord, and of the section about it.
INTERLOCK_LANE Lane3 spin_of_rod(const RodNearest& n, const RodTurning& turning,
                                 const RodMotionLane& motion)
{
  const Lane3 apart = motion.v2 - motion.v1;
  const double roll = dot(turning.spin_share1, motion.w1) + dot(turning.spin_share2, motion.w2) +
                      dot(turning.chord_share, apart);
  return n.inverse_length * n.inverse_length * cross(n.chord, apart) + roll * n.e1;
}

// rod_loads() of ribs.h.
struct RodLoadsLane {
  Lane3 force1, force2, moment1, moment2;
};

INTERLOCK_LANE RodLoadsLane loads_on_rod(const RodNearest& n, const RodTurning& turning,
                                         Lane3 force, Lane3 moment)
{
  const double roll = dot(moment, n.e1);
  const Lane3 couple =
      n.inverse_length * n.inverse_length * cross(moment, n.chord) + roll * turning.chord_share;
  return {(1 - n.xi) * force - couple, n.xi * force + couple, roll * turning.spin_share1,
          roll * turning.spin_share2};
}
} // namespace interlock::dem
