// A sequence of random numbers from a seed: each draw depends on all draws before it. For making
// stones and clumps; a simulation uses counter_stream.h.
#pragma once

#include "dem/random_draws.h"

#include <random>

namespace interlock::dem
{
class RandomStream : public RandomDraws<std::mt19937_64>
{
public:
  explicit RandomStream(std::uint64_t seed) : RandomDraws(std::mt19937_64(seed)) {}
};
} // namespace interlock::dem
