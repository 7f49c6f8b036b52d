// Shares of the stone that its member spheres carry, for codes that know a clump only as the sum of
// its members.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <vector>

namespace interlock::dem
{
// Volume of the stone that each sphere stands for [m3]; times the density, its mass. All are above
// 0, and as solid spheres of these masses the members have, to rounding,
//   the volume of the stone, its centre (the origin) and its inertia (unit_inertia, no products),
// which no uniform density gives, because overlaps count as often as they occur. Among all such
// shares they are the nearest to shares in proportion to r^3 (least relative entropy, found by
// Newton's method for the ten multipliers). Where no positive shares do that, as in clumps of few
// spheres, the moments are given up, then the axes, then the centre; the volume always agrees. What
// is left can be seen with sum_deviation().
std::vector<double> member_volumes(const ClumpShape& shape);

// By how much the sums over the member spheres of these volumes, 2/5 r^2 of each included, miss the
// shape, the worst of: volume; centre over the bounding radius; principal moments; products of
// inertia over the root of the two moments [-].
double sum_deviation(const ClumpShape& shape, const std::vector<double>& volumes);
// Below this the sums are the stone's [-].
constexpr double allowed_sum_deviation = 1e-6;
} // namespace interlock::dem
