// The geogrid as it is laid into the box: the lattice, who holds it, and which ribs are one row.
//
// Frame of the pull-out (pull_out.h): the sheet is plane, its front transverse rib is the first one
// along x, and the clamp holds that.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/geogrid_parameters.h"
#include "dem/vector.h"
#include "fem/lattice/lattice.h"

#include <vector>

namespace interlock::coupling
{
struct GeogridSheet {
  fem::Lattice lattice;     // unloaded, in its place
  std::vector<int> clamped; // nodes
  // Lines of ribs. Those that run across, more than 45 degrees from x, form a row where they lie at
  // the same x; rows are counted from the clamped one. All others run along, diagonal ones
  // included.
  std::vector<int> along;
  std::vector<std::vector<int>> rows;
  double thickness = 0;   // of the thickest place, junctions included [m]
  double room_behind = 0; // between the first two rows of ribs; infinite if there is one [m]
};

// Where the middle of the front transverse rib lies: outside the slot by the overhang [m].
dem::Vector3 front_of_geogrid(const GeogridParameters& parameters, const BoxParameters& box);

// The geogrid of the product, the drawing or the entries, with its front there. Throws InputError,
// one sentence, when a product has no lattice of rigid junctions, or a drawing is no plane lattice.
GeogridSheet lay_geogrid(const GeogridParameters& parameters, const dem::Vector3& front);

// Throws InputError when the sheet is wider or longer than the box. Where ribs that do not run
// along x end freely they are cut square to y, as a sheet is: their width reaches no further.
void check_sheet_fits(const GeogridSheet& sheet, const BoxParameters& box);
} // namespace interlock::coupling
