// What is read off the curve of a strength test. Places ascend: displacements [m] or strains [-].
#pragma once

#include <cstddef>
#include <vector>

namespace interlock::coupling
{
// Means of `value`, each of which is the mean since the place before it, over `length` around each
// place; towards the ends over less, down to the first and the last value themselves, so that a
// slope is not shifted.
std::vector<double> centred_mean(const std::vector<double>& place, const std::vector<double>& value,
                                 double length);

// Mean of values each of which is the mean since the place before it, over the last `share` of the
// way.
double mean_over_end(const std::vector<double>& place, const std::vector<double>& value,
                     double share);

// What is left at the end of a test: means of one curve over means of another, over the last fifth
// of the way. The same of the whole way. [-]
constexpr double end_share = 0.2, whole_way = 1;
inline double ratio_over_end(const std::vector<double>& place, const std::vector<double>& above,
                             const std::vector<double>& below, double share)
{
  return mean_over_end(place, above, share) / mean_over_end(place, below, share);
}

// Where one curve is largest over another, which is positive: the first such point.
std::size_t largest_ratio(const std::vector<double>& above, const std::vector<double>& below);

// Slope of the straight line of least squares through the points within `length`/2 of `centre`; 0
// through less than two.
double slope_around(const std::vector<double>& place, const std::vector<double>& value,
                    double centre, double length);

// Where the broken line through the points first reaches `level`; the last place if it never does.
double first_place_at(const std::vector<double>& place, const std::vector<double>& value,
                      double level);
} // namespace interlock::coupling
