// Forces and torques of contacts summed clump by clump, in the order of the calls. A sum is a quad
// of numbers, so that a contact adds all components of a vector at once.
#pragma once

#include "dem/bodies/component_arrays.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace interlock::dem
{
using Quad = double __attribute__((vector_size(32)));

inline Quad load_quad(const double* numbers)
{
  Quad quad;
  std::memcpy(&quad, numbers, sizeof quad);
  return quad;
}

// Rows become columns.
inline std::array<Quad, 4> transposed(Quad a, Quad b, Quad c, Quad d)
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

// (x, y, z, 0) of entries k to k + 3 of a field.
inline std::array<Quad, 4> quads(const VectorField& field, int k)
{
  return transposed(load_quad(field.row(0) + k), load_quad(field.row(1) + k),
                    load_quad(field.row(2) + k), Quad{});
}

class WrenchSums
{
public:
  // Zero for n clumps.
  void clear(int n)
  {
    sums_.resize(padded(n));
    std::memset(static_cast<void*>(sums_.data()), 0, sums_.size() * sizeof(Wrench));
  }

  void add(std::int64_t clump, Quad force, Quad torque)
  {
    sums_[clump].force += force;
    sums_[clump].torque += torque;
  }

  // Sets both fields, of all clumps.
  void write(VectorField& force, VectorField& torque) const
  {
    for (int i = 0; i < force.padded_size(); i += 4) {
      const Wrench* s = &sums_[i];
      const auto f = transposed(s[0].force, s[1].force, s[2].force, s[3].force);
      const auto t = transposed(s[0].torque, s[1].torque, s[2].torque, s[3].torque);
      for (int c = 0; c < 3; ++c) {
        std::memcpy(force.row(c) + i, &f[c], sizeof(Quad));
        std::memcpy(torque.row(c) + i, &t[c], sizeof(Quad));
      }
    }
  }

private:
  struct Wrench {
    Quad force, torque;
  };
  std::vector<Wrench> sums_;
};
} // namespace interlock::dem
