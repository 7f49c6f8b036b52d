#include "dem/ribs/ribs.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
RibProximity rib_proximity(const Rib& rib, const Vector3& centre, double radius)
{
  RibProximity result;
  const Vector3 chord = rib.x[1] - rib.x[0];
  const double length_squared = chord.squaredNorm();
  result.xi = std::clamp(chord.dot(centre - rib.x[0]) / length_squared, 0., 1.);
  result.centre = rib.x[0] + result.xi * chord;

  // Section axes, made perpendicular to the chord so that the nearest point is exact.
  const Vector3 e1 = chord / std::sqrt(length_squared);
  const Vector3 width = (1 - result.xi) * rib.width_axis[0] + result.xi * rib.width_axis[1];
  const Vector3 across = width - width.dot(e1) * e1;
  const Vector3 e2 = across.normalized();
  const Vector3 e3 = e1.cross(e2);
  const Vector3 d = centre - result.centre;
  const double core_width = rib.half_width - rib.rounding;
  const double core_thickness = rib.half_thickness - rib.rounding;
  const double y = std::clamp(d.dot(e2), -core_width, core_width);
  const double z = std::clamp(d.dot(e3), -core_thickness, core_thickness);
  result.core = result.centre + y * e2 + z * e3;

  const Vector3 gap = centre - result.core;
  result.distance = gap.norm();
  result.overlap = radius + rib.rounding - result.distance;
  result.normal = result.distance > 1e-12 ? Vector3(gap / result.distance) : e3;
  const bool at_an_end = result.xi == 0 || result.xi == 1;
  const double twist = // of the section, per length [rad/m]
      at_an_end ? 0
                : e3.dot(rib.width_axis[1] - rib.width_axis[0]) /
                      std::sqrt(across.squaredNorm() * length_squared);
  result.lean = -twist * result.normal.dot(y * e3 - z * e2) * e1;
  return result;
}

namespace
{
// How the section at xi turns about the chord: e3 . d(e2) with e2 the width axis across the chord.
// d(e2) has the spins of both ends in it, and, where sections lean along the chord, its turn.
struct Turning {
  Vector3 spin_share[2]; // of each end's spin [-]
  Vector3 chord_share;   // of the velocity of end 2 against end 1 [1/m]
};

Turning turning_about_chord(const Rib& rib, double xi)
{
  const Vector3 chord = rib.x[1] - rib.x[0];
  const double length = chord.norm();
  const Vector3 e1 = chord / length;
  const Vector3 width = (1 - xi) * rib.width_axis[0] + xi * rib.width_axis[1];
  const double lean = width.dot(e1);
  const Vector3 across = width - lean * e1;
  const double across_length = across.norm();
  const Vector3 e3 = e1.cross(across / across_length);
  return {{(1 - xi) / across_length * rib.width_axis[0].cross(e3),
           xi / across_length * rib.width_axis[1].cross(e3)},
          -lean / (across_length * length) * e3};
}
} // namespace

Vector3 rod_spin(const Rib& rib, double xi)
{
  const Vector3 chord = rib.x[1] - rib.x[0], apart = rib.v[1] - rib.v[0];
  const Turning turning = turning_about_chord(rib, xi);
  const double roll = turning.spin_share[0].dot(rib.w[0]) + turning.spin_share[1].dot(rib.w[1]) +
                      turning.chord_share.dot(apart);
  return chord.cross(apart) / chord.squaredNorm() + roll * chord.normalized();
}

RodLoads rod_loads(const Rib& rib, const RibWrench& wrench)
{
  const Vector3 chord = rib.x[1] - rib.x[0];
  const double roll = wrench.moment.dot(chord.normalized());
  const Turning turning = turning_about_chord(rib, wrench.xi);
  const Vector3 couple =
      wrench.moment.cross(chord) / chord.squaredNorm() + roll * turning.chord_share;
  return {{(1 - wrench.xi) * wrench.force - couple, wrench.xi * wrench.force + couple},
          {roll * turning.spin_share[0], roll * turning.spin_share[1]}};
}
} // namespace interlock::dem
