#include "apps/drop/force_drop.h"

#include <algorithm>
#include <cmath>

namespace interlock::apps
{
namespace
{
using Numbers = std::vector<double>;

double median(Numbers values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// The last point of a maximum, which may be flat, to which the force has risen.
bool ends_a_maximum(const Numbers& force, std::size_t k)
{
  if (k + 1 >= force.size() || force[k + 1] >= force[k]) return false;
  while (k > 0 && force[k - 1] == force[k]) --k;
  return k > 0 && force[k - 1] < force[k];
}

// Where the broken line through the points, from `from` on, first is at `level`.
double first_place_below(const Numbers& place, const Numbers& force, std::size_t from, double level)
{
  std::size_t k = from + 1;
  while (force[k] > level) ++k;
  const double share = (force[k - 1] - level) / (force[k - 1] - force[k]);
  return place[k - 1] + share * (place[k] - place[k - 1]);
}
} // namespace

Numbers running_median(const Numbers& place, const Numbers& value, double half)
{
  // Sums of decimal lengths have no exact binary form.
  constexpr double room = 1e-9;
  const std::size_t n = place.size();
  Numbers result;
  std::size_t begin = 0, end = 0;
  for (std::size_t k = 0; k < n; ++k) {
    while (place[begin] < place[k] - half - room) ++begin;
    while (end < n && place[end] <= place[k] + half + room) ++end;
    std::size_t first = std::min(begin, k > 0 ? k - 1 : 0),
                last = std::min(std::max(end, k + 2), n);
    if (last - first < 3) first = std::min(first, n - std::min<std::size_t>(n, 3));
    if (last - first < 3) last = std::min<std::size_t>(n, first + 3);
    result.push_back(median(Numbers(value.begin() + first, value.begin() + last)));
  }
  return result;
}

std::optional<ForceDrop> largest_drop(const Numbers& place, const Numbers& force,
                                      const DropSearch& search)
{
  const Numbers smooth = running_median(place, force, search.smooth);
  std::size_t before = 0, after = 0;
  const auto fall = [&](std::size_t i, std::size_t j) { return smooth[i] - smooth[j]; };
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] < search.from || !ends_a_maximum(smooth, i)) continue;
    for (std::size_t j = i + 1; j < place.size() && place[j] <= place[i] + search.within; ++j)
      if (fall(i, j) > fall(before, after)) before = i, after = j;
  }
  if (before == after) return {};
  ForceDrop drop;
  drop.before = {place[before], smooth[before]};
  drop.after = {place[after], smooth[after]};
  const double half = 0.5 * (smooth[before] + smooth[after]);
  drop.during = {first_place_below(place, smooth, before, half), half};
  drop.highest = *std::max_element(smooth.begin(), smooth.end());
  drop.counts = drop.fall() >= search.least * drop.highest;
  return drop;
}
} // namespace interlock::apps
