// The convex hull of a set of points, by Qhull.
#pragma once

#include "dem/vector.h"

#include <vector>

namespace interlock::dem
{
// Volume of the convex hull [m3]. Throws InputError when the points span no volume.
// Source: Barber, Dobkin and Huhdanpaa, ACM Trans. Math. Software 22(4) (1996), 469-483.
double convex_hull_volume(const std::vector<Vector3>& points);
} // namespace interlock::dem
