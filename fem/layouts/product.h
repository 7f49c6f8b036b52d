// A geogrid product: what its pieces are cut from.
#pragma once

#include "fem/lattice/lattice.h"
#include "fem/layouts/junction_zones.h"

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace interlock::fem
{
enum class Pattern { biaxial, uniaxial, triaxial };

// Directions as on data sheets: along is the machine direction of the roll (x of a piece), across
// the cross-machine direction (y).
struct GeogridProduct {
  Pattern pattern = Pattern::biaxial;
  // Biaxial: centre to centre of the ribs that run across, and of those that run along. Uniaxial:
  // of the bars, which run across, and of the ribs. Triaxial: distance of neighbouring transverse
  // ribs (the height of a triangle), and their distance from junction to junction (the side) [m].
  double pitch_along = 0, pitch_across = 0;
  RibProfile ribs_along;  // that run along; of a triaxial geogrid both diagonal families
  RibProfile ribs_across; // that run across
  JunctionZone junctions; // thicker zones around the junctions; reach 0: none
  JunctionStiffness junction_stiffness; // rigid where it is infinite
  int elements_per_rib = 8;             // between two junctions

  // Mass per area of a large sheet, without thicker zones [kg/m2].
  double mass_per_area() const;
};

// The same sheet seen from the other direction: along and across change places.
// Throws std::invalid_argument for a product that is not biaxial.
GeogridProduct turned(const GeogridProduct& product);

// The rib lines of a piece of whole apertures (triaxial: triangle heights and sides), without
// thicker zones. `front` is the middle of its first transverse rib [m]; the piece lies behind it
// along x, in a plane of equal z. Throws std::invalid_argument when a number, a pitch or a section
// is not valid.
std::vector<RibLine> lines_of_piece(const GeogridProduct& product, int apertures_along,
                                    int apertures_across, const Eigen::Vector3d& front);

// Such a piece that starts at the origin, with its thicker zones.
Lattice piece(const GeogridProduct& product, int apertures_along, int apertures_across);

// Distance of the first and the last row of its junctions along x [m].
inline double length_of_piece(const GeogridProduct& product, int apertures_along)
{
  return apertures_along * product.pitch_along;
}
// Width of the sheet whose ribs a piece has: a biaxial one has a rib more than apertures [m].
double width_of_piece(const GeogridProduct& product, int apertures_across);
} // namespace interlock::fem
