// Faults that a lattice can have although each of its lines is sound.
#pragma once

#include "fem/lattice/lattice.h"

namespace interlock::fem
{
// Throws std::invalid_argument when the lattice falls into pieces that no junction connects; the
// sentence says how many, how large and where.
void check_connected(const Lattice& lattice);

// Throws std::invalid_argument when
// * two elements lie over each other, wholly or in part,
// * elements meet or cross away from a common vertex: their centre lines come closer than a
//   thousandth of the shortest element,
// * parallel ribs overlap side by side: the distance of their centre lines is below half the sum of
//   their sizes in that direction; ribs without a shape have no size.
// The sentence names the two lines, by their numbers, and the place.
void check_overlaps(const Lattice& lattice);

// Throws std::invalid_argument when a stiffness or the line density of an element is not positive
// and finite; the sentence names the line by its number.
void check_sections(const Lattice& lattice);

// All of the above.
void check_lattice(const Lattice& lattice);
} // namespace interlock::fem
