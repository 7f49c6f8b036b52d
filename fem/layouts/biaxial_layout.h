// Geometry of a biaxial geogrid: two families of ribs that cross at right angles.
#pragma once

#include "fem/ribs/rib_line.h"
#include "fem/ribs/rib_section.h"

#include <Eigen/Dense>

#include <vector>

namespace interlock::fem
{
// World frame. The lattice lies in the plane z = origin.z; its front transverse rib is at x =
// origin.x; longitudinal ribs run from there along +x; transverse ribs run along y, centred on
// origin.y. There are apertures_across + 1 longitudinal and apertures_along + 1 transverse ribs.
struct BiaxialLayout {
  int apertures_along = 0;         // along x, the direction of the pull
  int apertures_across = 0;        // along y
  double pitch_along = 0;          // centre line to centre line along x [m]
  double pitch_across = 0;         // centre line to centre line along y [m]
  int elements_per_rib = 8;        // between two junctions
  RibSection section_along;        // of the ribs that run along x
  RibSection section_across;       // of the ribs that run along y
  Eigen::Vector3d origin{0, 0, 0}; // middle of the front transverse rib [m]
};

// The rib lines: longitudinal ribs from small to large y, each from small to large x, then
// transverse ribs from small to large x, each from small to large y. Element vertices coincide at
// the junctions. Throws std::invalid_argument when a count or a pitch is not positive, a section is
// not valid, or ribs are as wide as their pitch.
std::vector<RibLine> rib_lines(const BiaxialLayout& layout);
} // namespace interlock::fem
