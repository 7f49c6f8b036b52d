// Random numbers that follow from a seed, an id and a purpose alone: nothing depends on what was
// drawn before, so there is no state to keep in a checkpoint and every rank draws alike.
#pragma once

#include "dem/random_draws.h"

#include <Random123/philox.h>

namespace interlock::dem
{
// What numbers are drawn for: draws of one purpose never shift those of another one.
enum class Draw : std::uint64_t { order = 1, place = 2, attitude = 3, velocity = 4 };

// Philox4x64-10: the counter is (block, id, purpose, 0), the key (seed, 0). Source: Salmon, Moraes,
// Dror and Shaw, Parallel random numbers: as easy as 1, 2, 3, SC 2011.
class PhiloxBits
{
public:
  PhiloxBits(std::uint64_t seed, std::int64_t id, Draw purpose)
      : key_{{seed, 0}}, id_(static_cast<std::uint64_t>(id)),
        purpose_(static_cast<std::uint64_t>(purpose))
  {
  }
  std::uint64_t operator()()
  {
    const unsigned word = static_cast<unsigned>(drawn_ % 4);
    if (word == 0) block_ = r123::Philox4x64()({{drawn_ / 4, id_, purpose_, 0}}, key_);
    ++drawn_;
    return block_[word];
  }

private:
  r123::Philox4x64::key_type key_;
  std::uint64_t id_, purpose_, drawn_ = 0;
  r123::Philox4x64::ctr_type block_{};
};

class CounterStream : public RandomDraws<PhiloxBits>
{
public:
  // `id`: of the stone, of the batch, of whatever the numbers belong to.
  CounterStream(std::uint64_t seed, std::int64_t id, Draw purpose)
      : RandomDraws(PhiloxBits(seed, id, purpose))
  {
  }
};
} // namespace interlock::dem
