// A geogrid product: what its pieces are cut from.
#pragma once

#include "fem/lattice/lattice.h"
#include "fem/layouts/junction_zones.h"

#include <string>

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

// A piece of whole apertures (triaxial: triangle heights and sides) that starts at x = 0; its
// middle lies at y = 0, z = 0. Throws std::invalid_argument when a number, a pitch or a section is
// not valid.
Lattice piece(const GeogridProduct& product, int apertures_along, int apertures_across);

// Distance of the first and the last row of its junctions along x [m].
inline double length_of_piece(const GeogridProduct& product, int apertures_along)
{
  return apertures_along * product.pitch_along;
}
// Width of the sheet whose ribs a piece has: a biaxial one has a rib more than apertures [m].
double width_of_piece(const GeogridProduct& product, int apertures_across);
} // namespace interlock::fem
