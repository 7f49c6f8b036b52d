// What is drawn from any source of random bits, with the same digits under every compiler: the
// distributions of the standard library are not specified to the bit.
#pragma once

#include "dem/vector.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace interlock::dem
{
// `Bits` is called without arguments and gives 64 random bits.
template <class Bits> class RandomDraws
{
public:
  explicit RandomDraws(Bits bits) : bits_(std::move(bits)) {}

  // In [0, 1), with 53 random bits.
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // In 0 .. count-1 (count >= 1). The bias of this mapping is below count/2^53.
  int index(int count) { return static_cast<int>(uniform() * count); }

  // Uniform on the unit sphere (Archimedes: z is uniform).
  Vector3 direction()
  {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * M_PI), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

  // Uniform over all rotations (Shoemake, Graphics Gems III, 1992).
  Quaternion rotation()
  {
    const double u = uniform(), a = uniform(0, 2 * M_PI), b = uniform(0, 2 * M_PI);
    return {std::sqrt(1 - u) * std::sin(a), std::sqrt(1 - u) * std::cos(a),
            std::sqrt(u) * std::sin(b), std::sqrt(u) * std::cos(b)};
  }

  // 0 .. count-1 in random order (Fisher and Yates).
  std::vector<int> permutation(int count)
  {
    std::vector<int> order(count);
    for (int i = 0; i < count; ++i) order[i] = i;
    for (int i = count - 1; i > 0; --i) std::swap(order[i], order[index(i + 1)]);
    return order;
  }

private:
  Bits bits_;
};
} // namespace interlock::dem
