// The grading of the paper's ballast.
#pragma once

#include <vector>

namespace interlock::dem
{
// Sieve sizes (stone_size.h) of a batch in ascending order [m]: the (i + 1/2)/count quantiles of
// the number distribution that has the mass shares of Table 5 of Ferellec and McDowell (2010), with
// 0-22 mm taken as 18-22 mm, so that even a dozen stones follow it.
std::vector<double> ballast_sizes(int count);
} // namespace interlock::dem
