// Geometry of a uniaxial geogrid: long thin ribs along the load, wide thick bars across.
#pragma once

#include "fem/ribs/rib_line.h"
#include "fem/ribs/rib_section.h"

#include <Eigen/Dense>

#include <vector>

namespace interlock::fem
{
// World frame. The lattice lies in the plane z = origin.z; its front bar is at x = origin.x; ribs
// run from there along +x; bars run along y, centred on origin.y. There are apertures_across + 1
// ribs and apertures_along + 1 bars.
//
// Within half a bar's width of a junction the rib is part of the bar; thicken_junctions with that
// distance makes it as thick.
struct UniaxialLayout {
  int apertures_along = 0;         // along x, the direction of the load
  int apertures_across = 0;        // along y
  double bar_pitch = 0;            // centre line to centre line of bars, along x [m]
  double rib_pitch = 0;            // centre line to centre line of ribs, along y [m]
  int elements_per_rib = 16;       // of a rib between two bars
  int elements_per_bar = 2;        // of a bar between two ribs
  RibSection rib;                  // section of the ribs
  RibSection bar;                  // section of the bars: width along x, thickness along z
  Eigen::Vector3d origin{0, 0, 0}; // middle of the front bar [m]
};

// The rib lines: ribs from small to large y, each from small to large x, then bars from small to
// large x, each from small to large y. Element vertices coincide at the junctions. Throws
// std::invalid_argument when a count or a pitch is not positive, a section is not valid, or ribs or
// bars are as wide as their pitch.
std::vector<RibLine> rib_lines(const UniaxialLayout& layout);
} // namespace interlock::fem
