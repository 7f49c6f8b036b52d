// Strains of the quadratic beam element for every number type: double and automatic
// differentiation. See quadratic_element.h for the formulas.
#pragma once

#include "fem/beam/beam_element.h"
#include "fem/beam/quadratic_element.h"

namespace interlock::fem
{
// Positions and rotations from the unloaded state of the three nodes.
template <class Number> struct QuadraticNodes {
  std::array<Triple<Number>, 3> x;
  std::array<Quadruple<Number>, 3> q;
};

// In the section's frame at one Gauss point: tangent L^T x' and axial vector of L^T L' [1/m].
template <class Number> struct CurveStrains {
  Triple<Number> tangent, curvature;
};

namespace detail
{
inline Quadruple<double> quadruple(const Eigen::Quaterniond& q)
{
  return {q.w(), q.x(), q.y(), q.z()};
}

template <class Number> Quadruple<Number> conjugate(const Quadruple<Number>& q)
{
  return {q[0], -q[1], -q[2], -q[3]};
}

// Rotation vector of a unit quaternion with positive scalar part, by the series of the kernel: with
// c the cosine and z the sine of a quarter of the angle, it is 4 z arcsin|z|/|z|.
template <class Number> Triple<Number> logarithm(const Quadruple<Number>& q)
{
  using std::sqrt;
  const Number c = sqrt(Number(0.5 + 0.5 * q[0]));
  const Number half_inverse = 0.5 / c;
  const Triple<Number> z{q[1] * half_inverse, q[2] * half_inverse, q[3] * half_inverse};
  const Number w = 0.5 * dot(z, z) / (1. + c);
  const Number factor = 4. * (1. + w * arc_series<Number>(w));
  return {factor * z[0], factor * z[1], factor * z[2]};
}

// Sum over k of (-square)^k first!/(2 k + first)!, divided by first!: for first = 2
// (1 - cos t)/t^2, for first = 3 (t - sin t)/t^3 with t^2 = square. Exact to rounding up to t
// = 1.7.
template <int first, class Number> Number entire_series(const Number& square)
{
  Number sum = Number(1.);
  for (int k = 10; k >= 1; --k)
    sum = 1. - square * sum * (1. / ((2 * k + first) * (2 * k + first - 1.)));
  return sum * (first == 2 ? 1. / 2 : 1. / 6);
}
} // namespace detail

// Local rotation vectors of the first and last node on top of the middle one's frame [rad].
template <class Number>
std::array<Triple<Number>, 2> local_rotations(const QuadraticBeam& beam,
                                              const QuadraticNodes<Number>& nodes)
{
  std::array<Triple<Number>, 2> psi;
  for (int i = 0; i < 2; ++i) {
    // conj(q2 f2) (q_i f_i)
    const Quadruple<Number> turned = detail::product(detail::conjugate(nodes.q[1]), nodes.q[2 * i]);
    const Quadruple<Number> right = detail::product(turned, detail::quadruple(beam.frame[2 * i]));
    const Quadruple<double> left = detail::quadruple(beam.frame[1].conjugate());
    // left * right with the constant factor first: conj(conj(right) conj(left)).
    psi[i] = detail::logarithm(
        detail::conjugate(detail::product(detail::conjugate(right), detail::conjugate(left))));
  }
  return psi;
}

template <class Number>
CurveStrains<Number> curve_strains(const QuadraticBeam& beam, const QuadraticNodes<Number>& nodes,
                                   const std::array<Triple<Number>, 2>& psi,
                                   const QuadraticBeam::GaussPoint& at)
{
  // The shape functions sum to one, their slopes to zero: differences to the middle node suffice.
  Triple<Number> turn, turn_slope, slope;
  for (int c = 0; c < 3; ++c) {
    turn[c] = at.shape[0] * psi[0][c] + at.shape[2] * psi[1][c];
    turn_slope[c] = at.slope[0] * psi[0][c] + at.slope[2] * psi[1][c];
    slope[c] = at.slope[0] * (nodes.x[0][c] - nodes.x[1][c]) +
               at.slope[2] * (nodes.x[2][c] - nodes.x[1][c]);
  }
  const auto middle = detail::rotation_matrix<Number>(
      detail::product(nodes.q[1], detail::quadruple(beam.frame[1])), Number(2.));
  const Triple<Number> y = detail::to_frame(middle, slope);

  // exp(-psi) y and the right tangent of the exponential map times psi'.
  const Number square = detail::dot(turn, turn);
  const Number b = detail::entire_series<2>(square), d = detail::entire_series<3>(square);
  const Number a = 1. - square * d;
  const Triple<Number> ty = detail::cross(turn, y), tty = detail::cross(turn, ty);
  const Triple<Number> ts = detail::cross(turn, turn_slope), tts = detail::cross(turn, ts);
  CurveStrains<Number> strains;
  for (int c = 0; c < 3; ++c) {
    strains.tangent[c] = y[c] - a * ty[c] + b * tty[c];
    strains.curvature[c] = turn_slope[c] - b * ts[c] + d * tts[c];
  }
  return strains;
}

template <class Number>
Number quadratic_energy(const QuadraticBeam& beam, const QuadraticNodes<Number>& nodes)
{
  const std::array<Triple<Number>, 2> psi = local_rotations(beam, nodes);
  Number sum = Number(0.);
  for (const QuadraticBeam::GaussPoint& at : beam.points) {
    const CurveStrains<Number> strains = curve_strains(beam, nodes, psi, at);
    for (int c = 0; c < 3; ++c) {
      const Number gamma = strains.tangent[c] - at.unloaded_tangent[c];
      const Number kappa = strains.curvature[c] - at.unloaded_curvature[c];
      sum = sum + 0.5 * at.weight *
                      (beam.force_stiffness[c] * gamma * gamma +
                       beam.moment_stiffness[c] * kappa * kappa);
    }
  }
  return sum;
}
} // namespace interlock::fem
