// Vector lanes: one double in each of several slots or elements.
#pragma once

#include "fem/beam/beam_element.h"

#include <experimental/simd>

namespace interlock::fem
{
using Wide = std::experimental::native_simd<double>;
constexpr int wide_lanes = static_cast<int>(Wide::size());

inline Wide load_wide(const double* from)
{
  return Wide(from, std::experimental::element_aligned);
}
inline void store_wide(const Wide& value, double* to)
{
  value.copy_to(to, std::experimental::element_aligned);
}

// Entries first ... first + wide_lanes - 1 of each of the arrays.
template <class Lanes, std::size_t n>
std::array<Wide, n> load_wide(const std::array<Lanes, n>& lanes, int first)
{
  std::array<Wide, n> values;
  for (std::size_t c = 0; c < n; ++c) values[c] = load_wide(lanes[c].data() + first);
  return values;
}

template <class Lanes, std::size_t n>
void store_wide(const std::array<Wide, n>& values, std::array<Lanes, n>& lanes, int first)
{
  for (std::size_t c = 0; c < n; ++c) store_wide(values[c], lanes[c].data() + first);
}

// exp(turn) q for a rotation vector [rad] in the world frame: series in |turn/2|^2, exact to
// rounding up to |turn| = 0.5, then pulled back to unit length.
inline Quadruple<Wide> turned(const Quadruple<Wide>& q, const Triple<Wide>& turn)
{
  const Triple<Wide> a{0.5 * turn[0], 0.5 * turn[1], 0.5 * turn[2]};
  const Wide s = detail::dot(a, a);
  const Wide cosine = 1. - s * (1. / 2 - s * (1. / 24 - s * (1. / 720 - s * (1. / 40320))));
  const Wide sine = 1. - s * (1. / 6 - s * (1. / 120 - s * (1. / 5040 - s * (1. / 362880))));
  const Quadruple<Wide> r =
      detail::product<Wide, Wide>({cosine, sine * a[0], sine * a[1], sine * a[2]}, q);
  const Wide to_unit = 1.5 - 0.5 * (r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
  return {to_unit * r[0], to_unit * r[1], to_unit * r[2], to_unit * r[3]};
}
} // namespace interlock::fem
