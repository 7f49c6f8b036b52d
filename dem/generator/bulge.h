// Spheres made larger by one length, so that their union has the volume of the stone.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <vector>

namespace interlock::dem
{
// Each radius larger by `bulge` [m].
std::vector<Sphere> bulged(std::vector<Sphere> spheres, double bulge);

// The smallest bulge [m] in 0 .. `largest` with which the union of the spheres has `volume` [m3],
// to the accuracy of UnionVolume; `largest` when none does.
double bulge_for_volume(const std::vector<Sphere>& spheres, double volume, double largest);
} // namespace interlock::dem
