#include "coupling/stones/curve_measures.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
// Of means between places, up to each place.
std::vector<double> integral(const std::vector<double>& place, const std::vector<double>& value)
{
  std::vector<double> sum(place.size(), 0.);
  for (std::size_t k = 1; k < place.size(); ++k)
    sum[k] = sum[k - 1] + value[k] * (place[k] - place[k - 1]);
  return sum;
}

double interpolated(const std::vector<double>& place, const std::vector<double>& value, double at)
{
  const auto above = std::lower_bound(place.begin(), place.end(), at);
  if (above == place.begin()) return value.front();
  if (above == place.end()) return value.back();
  const std::size_t k = above - place.begin();
  const double share = (at - place[k - 1]) / (place[k] - place[k - 1]);
  return value[k - 1] + share * (value[k] - value[k - 1]);
}
} // namespace

std::vector<double> centred_mean(const std::vector<double>& place, const std::vector<double>& value,
                                 double length)
{
  const std::vector<double> sum = integral(place, value);
  std::vector<double> result = value;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const double half = std::min({0.5 * length, place[k] - place.front(), place.back() - place[k]});
    if (half <= 0) continue;
    result[k] =
        (interpolated(place, sum, place[k] + half) - interpolated(place, sum, place[k] - half)) /
        (2 * half);
  }
  return result;
}

double mean_over_end(const std::vector<double>& place, const std::vector<double>& value,
                     double share)
{
  const std::vector<double> sum = integral(place, value);
  const double way = share * (place.back() - place.front());
  if (!(way > 0)) return value.back();
  return (sum.back() - interpolated(place, sum, place.back() - way)) / way;
}

std::size_t largest_ratio(const std::vector<double>& above, const std::vector<double>& below)
{
  std::size_t largest = 0;
  for (std::size_t k = 1; k < above.size(); ++k)
    if (above[k] * below[largest] > above[largest] * below[k]) largest = k;
  return largest;
}

double slope_around(const std::vector<double>& place, const std::vector<double>& value,
                    double centre, double length)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const double d = place[k] - centre;
    if (std::abs(d) > 0.5 * length) continue;
    n += 1, x += d, y += value[k], xx += d * d, xy += d * value[k];
  }
  const double spread = n * xx - x * x;
  return spread > 0 ? (n * xy - x * y) / spread : 0;
}

double first_place_at(const std::vector<double>& place, const std::vector<double>& value,
                      double level)
{
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (value[k] < level) continue;
    if (k == 0) return place[0];
    const double share = (level - value[k - 1]) / (value[k] - value[k - 1]);
    return place[k - 1] + share * (place[k] - place[k - 1]);
  }
  return place.back();
}
} // namespace interlock::coupling
