// Geometry of a triaxial geogrid: equilateral triangles of ribs in three directions.
#pragma once

#include "fem/ribs/rib_line.h"
#include "fem/ribs/rib_section.h"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace interlock::fem
{
// World frame. The lattice lies in the plane z = origin.z. Transverse ribs run along y, the first
// at x = origin.x, the others behind it at larger x; the two diagonal families make 30 degrees with
// the x axis: rising ribs go towards +y with growing x, falling ribs towards -y. The triangles fill
// the rectangle 0 <= x - origin.x <= length, |y - origin.y| <= width/2 as far as junctions lie
// inside it; there are only whole ribs between two junctions. Every second transverse rib is
// shifted by half a side and shorter by one.
struct TriaxialLayout {
  double length = 0;               // of the rectangle along x, at least one triangle height [m]
  double width = 0;                // of the rectangle along y, at least one side [m]
  double side = 0;                 // of a triangle: from junction to junction along a rib [m]
  int elements_per_rib = 8;        // between two junctions
  RibSection section_across;       // of the transverse ribs, which run along y
  RibSection section_rising;       // of the diagonal ribs that rise with x
  RibSection section_falling;      // of those that fall
  Eigen::Vector3d origin{0, 0, 0}; // middle of the front transverse rib [m]
};

// Side of the triangles of a product whose sheet gives the hexagon pitch, the distance between
// alternate parallel ribs (Tensar's model specification of TriAx geogrids): two triangle heights,
// sqrt(3) sides. A sheet that gives a rib pitch as the distance between neighbouring parallel ribs
// means half of it: 40 mm for the product with 80 mm between alternate ribs, side 46.2 mm.
inline double side_of_hexagon_pitch(double pitch)
{
  return pitch / std::sqrt(3.);
}

// The rib lines: transverse ribs from small to large x, each from small to large y; then rising,
// then falling ribs, each from small to large x. Element vertices coincide at the junctions.
// Throws std::invalid_argument when a size or the number of elements is not positive, the rectangle
// has no room for a triangle, a section is not valid, or the ribs fill the triangles: mean width of
// the three families at least two thirds of a triangle height.
std::vector<RibLine> rib_lines(const TriaxialLayout& layout);
} // namespace interlock::fem
