// The rotation of a rotation vector, for plain numbers and for automatic differentiation.
#pragma once

#include "fem/beam/beam_element.h"

#include <unsupported/Eigen/AutoDiff>

#include <cmath>

namespace interlock::fem
{
namespace detail
{
inline double value_of(double number)
{
  return number;
}
template <class Derivatives> double value_of(const Eigen::AutoDiffScalar<Derivatives>& number)
{
  return value_of(number.value());
}

// Unit quaternion of a rotation vector [rad], any length.
template <class Number> Quadruple<Number> exponential(const Triple<Number>& turn)
{
  using std::cos, std::sin, std::sqrt;
  const Number square = dot(turn, turn);
  Number cosine, half_sine; // of half the angle; the latter divided by the angle
  if (value_of(square) < 1e-2) {
    // Series, because the square root has no derivative at zero; the next terms are below 1e-17.
    const Number s = 0.25 * square;
    cosine = 1. - s * (1. / 2 - s * (1. / 24 - s * (1. / 720 - s * (1. / 40320))));
    half_sine = 0.5 * (1. - s * (1. / 6 - s * (1. / 120 - s * (1. / 5040 - s * (1. / 362880)))));
  } else {
    const Number angle = sqrt(square), half = 0.5 * angle;
    cosine = cos(half);
    half_sine = sin(half) / angle;
  }
  return {cosine, half_sine * turn[0], half_sine * turn[1], half_sine * turn[2]};
}
} // namespace detail
} // namespace interlock::fem
