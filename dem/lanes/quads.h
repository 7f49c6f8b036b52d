// Four numbers in one register: how a vector of a body is read and added in one go, and how four
// bodies become four lanes.
#pragma once

#include "dem/lane_vector.h"

#include <array>
#include <cstring>

namespace interlock::dem
{
using Quad = double __attribute__((vector_size(32)));

INTERLOCK_LANE Quad load_quad(const double* numbers)
{
  Quad quad;
  std::memcpy(&quad, numbers, sizeof quad);
  return quad;
}
INTERLOCK_LANE void store_quad(double* numbers, Quad quad)
{
  std::memcpy(numbers, &quad, sizeof quad);
}

// Rows become columns.
INTERLOCK_LANE std::array<Quad, 4> transposed(Quad a, Quad b, Quad c, Quad d)
{
  const Quad ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Quad ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Quad cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab02, cd02, 0, 1, 4, 5),
          __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5),
          __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7),
          __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7)};
}

// Four lanes out of four rows: quad k is (x[k], y[k], z[k], w[k]).
INTERLOCK_LANE std::array<Quad, 4> lanes_to_quads(const double* x, const double* y, const double* z,
                                                  const double* w)
{
  return transposed(load_quad(x), load_quad(y), load_quad(z), load_quad(w));
}
} // namespace interlock::dem
