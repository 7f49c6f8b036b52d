// Random numbers with the same digits under every compiler: the engines of the standard library are
// specified to the bit, its distributions are not.
#pragma once

#include "dem/vector.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace interlock::dem
{
class RandomStream
{
public:
  explicit RandomStream(std::uint64_t seed) : engine_(seed) {}

  // In [0, 1), with 53 random bits.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
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
  std::mt19937_64 engine_;
};
} // namespace interlock::dem
