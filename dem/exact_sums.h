// Sums that do not depend on the order of their terms, so that several ranks find the same as one:
// terms are rounded to a grid that is wide enough for the sum of all to be exact (the idea of
// Demmel and Nguyen, IEEE Trans. Comput. 64 (2015) 2060-2070).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace interlock::dem
{
// The multiple of 2^exponent that is nearest to x, for |x| < 2^(51 + exponent). A sum of such
// numbers is exact while it stays below 2^(53 + exponent). -52 <= exponent < 0.
template <int exponent, class Number> Number on_grid(const Number& x)
{
  static_assert(-52 <= exponent && exponent < 0);
  constexpr double shift = 1.5 * static_cast<double>(1ull << (52 + exponent));
  return (x + shift) - shift;
}

// Forces of contacts on walls: to 6e-11 N, up to 524 kN in all; moments likewise [N m].
constexpr int force_grid = -34;
// The force of a clamp, over ends of ribs and sub-steps: to 5e-10 N, up to 8.4 MN.
constexpr int clamp_grid = -30;
// How much such a force changes by the speed of the wall: to 1e-8 N s/m, up to 1e8 N s/m.
constexpr int response_grid = -26;
// What contacts with ribs do in a sub-step: to 9e-16 J, up to 8 J in all.
constexpr int energy_grid = -50;

// An exact sum over many steps of numbers on the grid 2^`grid`, of which each rank adds its own
// part.
template <int grid> class SharedSum
{
public:
  // Less than 2^(63 + grid).
  void add(double number)
  {
    since_ += static_cast<std::int64_t>(std::llround(std::ldexp(number, -grid)));
  }
  // Makes it the same on all ranks; `sum` adds a number over them.
  template <class Sum> void unite(const Sum& sum)
  {
    constexpr Wide piece = Wide(1) << 40;
    const double high = sum(static_cast<double>(since_ / piece)),
                 low = sum(static_cast<double>(since_ % piece));
    before_ += static_cast<Wide>(high) * piece + static_cast<Wide>(low);
    since_ = 0;
  }
  // As of the last unite().
  double value() const { return std::ldexp(static_cast<double>(before_), grid); }
  // With what was added since.
  template <class Sum> double value(const Sum& sum) const
  {
    SharedSum all = *this;
    all.unite(sum);
    return all.value();
  }

  // Of a sum that is united.
  template <class Archive> friend void exchange(Archive& archive, SharedSum& sum)
  {
    constexpr Wide piece = Wide(1) << 40;
    auto high = static_cast<std::int64_t>(sum.before_ / piece),
         low = static_cast<std::int64_t>(sum.before_ % piece);
    archive("high", high);
    archive("low", low);
    if (Archive::reading) sum.before_ = static_cast<Wide>(high) * piece + low;
  }

private:
  __extension__ using Wide = __int128;
  Wide before_ = 0, since_ = 0;
};

// What several ranks add up, entry by entry, and the largest of what they have; none on one rank.
struct OverRanks {
  std::function<void(std::vector<double>&)> sum;
  std::function<double(double)> largest;
};

// Sum of the numbers of all ranks, to within 2^-51 of the largest times the count of those that are
// not zero.
inline double order_free_sum(const std::vector<double>& numbers, const OverRanks& ranks)
{
  double largest = 0;
  std::vector<double> sum = {0};
  for (const double x : numbers) largest = std::max(largest, std::abs(x)), sum[0] += x != 0;
  if (ranks.sum) ranks.sum(sum), largest = ranks.largest(largest);
  const double bound = sum[0] * largest;
  if (!(bound > 0) || !std::isfinite(bound)) return bound;
  const double shift = 1.5 * std::exp2(std::ceil(std::log2(bound)) + 1);
  sum[0] = 0;
  for (const double x : numbers) sum[0] += (x + shift) - shift;
  if (ranks.sum) ranks.sum(sum);
  return sum[0];
}
} // namespace interlock::dem
