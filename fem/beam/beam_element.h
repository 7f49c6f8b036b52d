// The geometrically exact (Simo-Reissner) beam element with two nodes and one integration point, as
// one kernel for every number type: double, std::experimental::simd (many elements at once) and
// automatic differentiation.
//
// Strains (Crisfield & Jelenic, Proc. R. Soc. A 455 (1999) 1125-1147, for two nodes): with unit
// nodal quaternions q1, q2 and phi the rotation from the first node's frame to the second's,
//   curvature     kappa = phi / h               along the geodesic between both frames,
//   force strains gamma = R^T (x2 - x1)/h - e1  with R the frame midway on that geodesic,
// so rigid motion leaves both unchanged to rounding. End forces and torques are minus the gradient
// of the strain energy h/2 (gamma.C gamma + kappa.D kappa) with respect to nodal displacement and
// spin. With the bowing of residual_bowing the stretch in it is that of the bowed centre line.
//
// No trigonometry: with z = sin(|phi|/4) e, c = cos(|phi|/4) = |q1 + q2|/2 and w = sin^2(|phi|/8),
// everything follows from G(w) = arcsin(sqrt w)/sqrt(w (1 - w)), a power series. It is exact to
// 1e-15 up to a relative rotation of 1.6 rad in one element, to 1e-12 up to 2.5 rad.
#pragma once

#include "fem/ribs/tension_law.h"

#include <array>
#include <cmath>
#include <limits>

namespace interlock::fem
{
template <class Number> using Triple = std::array<Number, 3>;
template <class Number> using Quadruple = std::array<Number, 4>; // quaternion w, x, y, z

// What does not change in a step: length [m] and frame of the unloaded element, stiffnesses of
// BeamSection.
template <class Number> struct BeamConstants {
  Number length, inverse_length;   // [m], [1/m]
  Quadruple<Number> frame;         // unloaded element frame to world
  Triple<Number> force_stiffness;  // axial, shear along e2, shear along e3 [N]
  Triple<Number> moment_stiffness; // torsion, bending about e2, about e3 [N m2]
  Triple<Number> bowing; // of shear along e2, along e3 [-], of curvature [m2]; see residual_bowing
  // Tension, see tension_law.h: softening s, yield force over EA, plastic stretch so far [-].
  Number softening{0.}, yield_stretch{std::numeric_limits<double>::infinity()}, plastic_stretch{0.};
};

// Whether the kernel heeds softening, yield and plastic stretch. `linear` is for speed alone: with
// constants that are linear, both give the same digits.
enum class Tension { linear, softening };

// What changes: position of both nodes [m] and rotation of both nodes from the unloaded state,
// world.
template <class Number> struct BeamEnds {
  Triple<Number> x1, x2;
  Quadruple<Number> q1, q2;
};

// Strains at the integration point, with what the forces need of the geometry there.
template <class Number> struct BeamStrains {
  Triple<Number> gamma;                   // stretch and shears in the midway frame [-]
  Triple<Number> kappa;                   // twist and curvatures in the midway frame [1/m]
  Triple<Number> chord;                   // x2 - x1 in the midway frame [m]
  Triple<Number> z;                       // sin(|phi|/4) times the axis of phi, midway frame
  Number inverse_c;                       // 1/cos(|phi|/4)
  Number g, k;                            // inverse tangent: S^-1 m = g m - k z (z . m)
  std::array<Triple<Number>, 3> rotation; // midway frame to world, by rows
};

// Action of the element on its nodes, world frame; the force on the second node is minus that on
// the first [N], torques are about the nodes [N m].
template <class Number> struct BeamEndLoads {
  Triple<Number> force1;
  Triple<Number> torque1, torque2;
};

namespace detail
{
template <class Number> Number dot(const Triple<Number>& a, const Triple<Number>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number> Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number, class Constant>
Quadruple<Number> product(const Quadruple<Number>& a, const Quadruple<Constant>& b)
{
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

// Rows of the rotation matrix of q/|q|; `scale` is 2/|q|^2.
template <class Number>
std::array<Triple<Number>, 3> rotation_matrix(const Quadruple<Number>& q, const Number& scale)
{
  const Number sx = scale * q[1], sy = scale * q[2], sz = scale * q[3];
  const Number wx = sx * q[0], wy = sy * q[0], wz = sz * q[0];
  const Number xx = sx * q[1], xy = sx * q[2], xz = sx * q[3];
  const Number yy = sy * q[2], yz = sy * q[3], zz = sz * q[3];
  return {{{1. - (yy + zz), xy - wz, xz + wy},
           {xy + wz, 1. - (xx + zz), yz - wx},
           {xz - wy, yz + wx, 1. - (xx + yy)}}};
}

template <class Number>
Triple<Number> to_world(const std::array<Triple<Number>, 3>& rows, const Triple<Number>& v)
{
  return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

template <class Number>
Triple<Number> to_frame(const std::array<Triple<Number>, 3>& rows, const Triple<Number>& v)
{
  return {rows[0][0] * v[0] + rows[1][0] * v[1] + rows[2][0] * v[2],
          rows[0][1] * v[0] + rows[1][1] * v[1] + rows[2][1] * v[2],
          rows[0][2] * v[0] + rows[1][2] * v[1] + rows[2][2] * v[2]};
}

// P(w) = (arcsin(sqrt w)/sqrt(w (1 - w)) - 1)/w: coefficients 2/3, 8/15, ... each 2n/(2n + 1) of
// the one before, summed from both halves so that the chain of dependent operations is half as
// long.
template <class Number> Number arc_series(const Number& w)
{
  constexpr double a1 = 2. / 3, a2 = a1 * 4 / 5, a3 = a2 * 6 / 7, a4 = a3 * 8 / 9,
                   a5 = a4 * 10 / 11, a6 = a5 * 12 / 13, a7 = a6 * 14 / 15, a8 = a7 * 16 / 17,
                   a9 = a8 * 18 / 19, a10 = a9 * 20 / 21, a11 = a10 * 22 / 23, a12 = a11 * 24 / 25;
  const Number y = w * w;
  const Number even = a1 + y * (a3 + y * (a5 + y * (a7 + y * (a9 + y * a11))));
  const Number odd = a2 + y * (a4 + y * (a6 + y * (a8 + y * (a10 + y * a12))));
  return even + w * odd;
}
} // namespace detail

// Strains of one element (or of one element a lane).
template <class Number, class Constant>
BeamStrains<Number> beam_strains(const BeamEnds<Number>& ends, const BeamConstants<Constant>& beam)
{
  using std::sqrt;
  const Quadruple<Number>&q1 = ends.q1, &q2 = ends.q2;
  const Quadruple<Number> sum{q1[0] + q2[0], q1[1] + q2[1], q1[2] + q2[2], q1[3] + q2[3]};
  const Number c =
      0.5 * sqrt(Number(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] + sum[3] * sum[3]));
  BeamStrains<Number> strains;
  strains.inverse_c = 1. / c;
  const Number half_square = 0.5 * strains.inverse_c * strains.inverse_c; // 2/|sum|^2
  strains.rotation = detail::rotation_matrix<Number>(detail::product(sum, beam.frame), half_square);

  // Vector part of q2 q1*: 2 c z in world axes, the same in either end frame turned to the world.
  const Triple<Number> v1{q1[1], q1[2], q1[3]}, v2{q2[1], q2[2], q2[3]};
  const Triple<Number> v12 = detail::cross(v1, v2);
  const Triple<Number> turn{q1[0] * v2[0] - q2[0] * v1[0] + v12[0],
                            q1[0] * v2[1] - q2[0] * v1[1] + v12[1],
                            q1[0] * v2[2] - q2[0] * v1[2] + v12[2]};
  const Triple<Number> two_c_z = detail::to_frame(strains.rotation, turn);
  for (int i = 0; i < 3; ++i) strains.z[i] = 0.5 * strains.inverse_c * two_c_z[i];

  const Number inverse_1c = 1. / (1. + c);
  const Number w = 0.5 * inverse_1c * detail::dot(strains.z, strains.z); // sin^2(|phi|/8)
  const Number p = detail::arc_series<Number>(w);
  const Number arc = 1. + w * p; // |phi|/4 over sin(|phi|/4)
  strains.g = arc * strains.inverse_c;
  strains.k = 0.5 * (p + 2.) * strains.inverse_c * inverse_1c;

  const Number to_kappa = 4. * beam.inverse_length * arc;
  const Triple<Number> dx{ends.x2[0] - ends.x1[0], ends.x2[1] - ends.x1[1],
                          ends.x2[2] - ends.x1[2]};
  strains.chord = detail::to_frame(strains.rotation, dx);
  for (int i = 0; i < 3; ++i) {
    strains.kappa[i] = to_kappa * strains.z[i];
    strains.gamma[i] = beam.inverse_length * strains.chord[i];
  }
  strains.gamma[0] = strains.gamma[0] - 1.;
  return strains;
}

// Stretch of the centre line, bowed between the nodes [-].
template <class Number, class Constant>
Number bowed_stretch(const BeamStrains<Number>& strains, const BeamConstants<Constant>& beam)
{
  const Triple<Number>&gamma = strains.gamma, &kappa = strains.kappa;
  return gamma[0] +
         0.5 * (beam.bowing[0] * gamma[1] * gamma[1] + beam.bowing[1] * gamma[2] * gamma[2] +
                beam.bowing[2] * (kappa[1] * kappa[1] + kappa[2] * kappa[2]));
}

// Plastic stretch after these strains [-].
template <class Number, class Constant>
Number plastic_stretch(const BeamStrains<Number>& strains, const BeamConstants<Constant>& beam)
{
  return plastic_stretch(bowed_stretch(strains, beam), beam.softening, beam.yield_stretch,
                         beam.plastic_stretch);
}

// Stretch that the axial force is proportional to [-].
template <Tension tension, class Number, class Constant>
Number elastic_stretch(const BeamStrains<Number>& strains, const BeamConstants<Constant>& beam)
{
  if constexpr (tension == Tension::linear)
    return bowed_stretch(strains, beam);
  else
    return bowed_stretch(strains, beam) - plastic_stretch(strains, beam);
}

// Section force (axial, shear along e2, e3) [N] in the midway frame.
template <Tension tension = Tension::softening, class Number, class Constant>
Triple<Number> section_force(const BeamStrains<Number>& strains,
                             const BeamConstants<Constant>& beam)
{
  const Number axial = beam.force_stiffness[0] * elastic_stretch<tension>(strains, beam);
  return {axial, (beam.force_stiffness[1] + beam.bowing[0] * axial) * strains.gamma[1],
          (beam.force_stiffness[2] + beam.bowing[1] * axial) * strains.gamma[2]};
}

// Section moment (torque, bending about e2, e3) [N m] in the midway frame.
template <Tension tension = Tension::softening, class Number, class Constant>
Triple<Number> section_moment(const BeamStrains<Number>& strains,
                              const BeamConstants<Constant>& beam)
{
  const Triple<Number>& kappa = strains.kappa;
  const Number axial = beam.force_stiffness[0] * elastic_stretch<tension>(strains, beam);
  return {beam.moment_stiffness[0] * kappa[0],
          (beam.moment_stiffness[1] + beam.bowing[2] * axial) * kappa[1],
          (beam.moment_stiffness[2] + beam.bowing[2] * axial) * kappa[2]};
}

// Strain energy of the element [J]; with softening what it would give back, not the work that it
// took.
template <Tension tension = Tension::softening, class Number, class Constant>
Number strain_energy(const BeamStrains<Number>& strains, const BeamConstants<Constant>& beam)
{
  const Triple<Constant>&c = beam.force_stiffness, &d = beam.moment_stiffness;
  const Triple<Number>&gamma = strains.gamma, &kappa = strains.kappa;
  const Number stretch = elastic_stretch<tension>(strains, beam);
  return 0.5 * beam.length *
         (c[0] * stretch * stretch + c[1] * gamma[1] * gamma[1] + c[2] * gamma[2] * gamma[2] +
          d[0] * kappa[0] * kappa[0] + d[1] * kappa[1] * kappa[1] + d[2] * kappa[2] * kappa[2]);
}

// Forces and torques on both nodes: minus the gradient of the strain energy (while plastic stretch
// grows, of strain energy and plastic work). Their sum is zero, and so is the sum of their moments
// about any point.
template <Tension tension = Tension::softening, class Number, class Constant>
BeamEndLoads<Number> end_loads(const BeamStrains<Number>& strains,
                               const BeamConstants<Constant>& beam)
{
  const Triple<Number> force = section_force<tension>(strains, beam),
                       moment = section_moment<tension>(strains, beam);
  const Triple<Number> lever = detail::cross(strains.chord, force);
  const Triple<Number> swing = detail::cross(lever, strains.z);
  const Number along = strains.k * detail::dot(strains.z, moment);
  const Number half_c = 0.5 * strains.inverse_c;
  Triple<Number> first, second;
  for (int i = 0; i < 3; ++i) {
    const Number half = 0.5 * lever[i];
    const Number bend = strains.g * moment[i] - along * strains.z[i] + half_c * swing[i];
    first[i] = half + bend;
    second[i] = half - bend;
  }
  return {detail::to_world(strains.rotation, force), detail::to_world(strains.rotation, first),
          detail::to_world(strains.rotation, second)};
}
} // namespace interlock::fem
