// A geogrid product: what its pieces are cut from.
#pragma once

#include "fem/lattice.h"

#include <string>

namespace interlock::fem
{
// Directions as on data sheets: along is the machine direction of the roll (x of a piece), across
// the cross-machine direction (y).

// The ribs of one direction: outer shape, and the section laws, which need not be those of the
// shape.
struct ProductRibs {
  RibSection shape;
  BeamSection section;
};

struct GeogridProduct {
  double pitch_along = 0;   // centre to centre of the ribs that run across [m]
  double pitch_across = 0;  // centre to centre of the ribs that run along [m]
  ProductRibs ribs_along;   // that run along
  ProductRibs ribs_across;  // that run across
  int elements_per_rib = 8; // between two junctions

  // Mass per area of a large sheet, ribs counted once from junction to junction [kg/m2].
  double mass_per_area() const;
};

// The same sheet seen from the other direction: along and across change places.
GeogridProduct turned(const GeogridProduct& product);

// A piece of whole apertures whose ribs along start at x = 0 and whose middle lies at y = 0, z = 0.
// Throws std::invalid_argument when a number, a pitch or a section is not valid.
Lattice piece(const GeogridProduct& product, int apertures_along, int apertures_across);
} // namespace interlock::fem
