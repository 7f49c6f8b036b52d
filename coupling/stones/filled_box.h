// How much is in a box, and how high it lies. The frame is that of box_walls.h.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "dem/bodies/clumps.h"

#include <cstdint>
#include <vector>

namespace interlock::coupling
{
// Mean height of the surface of the stones over the plan of the box: highest point under a raster
// of vertical rays 5 mm apart, floor where a ray meets no stone [m].
double surface_height(const dem::Clumps& clumps, const BoxParameters& box);

// Highest point of a member sphere, at least `floor` [m].
double highest_point(const dem::Clumps& clumps, double floor);
// The same of the bounding balls: higher, but cheap [m].
double highest_ball(const dem::Clumps& clumps);

// Marks stones whose centre of mass is above `height` [m].
std::vector<bool> clumps_above(const dem::Clumps& clumps, double height);
// Marks what has fallen out of the box, through the slot.
std::vector<bool> clumps_below_floor(const dem::Clumps& clumps);

int stones(const dem::Clumps& clumps); // without what lies on top as a load
// Of stones with their centre inside the box and above `height` [m], [kg].
double mass_above(const dem::Clumps& clumps, const BoxParameters& box, double height);
// Of stones with their centre inside the box that were added with this id or later [kg].
double mass_since(const dem::Clumps& clumps, const BoxParameters& box, std::int64_t id);
inline double mass_in_box(const dem::Clumps& clumps, const BoxParameters& box)
{
  return mass_above(clumps, box, 0);
}
// What of the box below its mean surface is filled, by the stones' own volumes (mass over density)
// and by their member spheres, whose union may miss a part of the stone. Porosity is what is left.
struct SolidVolumes {
  double stones = 0, clumps = 0; // [m3]
};
SolidVolumes solid_volumes(const dem::Clumps& clumps, const BoxParameters& box);
} // namespace interlock::coupling
