// What is read off the curve of a strength test. Places ascend: displacements [m] or strains [-].
#pragma once

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

// Slope of the straight line of least squares through the points within `length`/2 of `centre`; 0
// through less than two.
double slope_around(const std::vector<double>& place, const std::vector<double>& value,
                    double centre, double length);

// Where the broken line through the points first reaches `level`; the last place if it never does.
double first_place_at(const std::vector<double>& place, const std::vector<double>& value,
                      double level);
} // namespace interlock::coupling
