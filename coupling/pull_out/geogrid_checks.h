// What the single entries of the geogrid of a pull-out cannot tell.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/geogrid_parameters.h"
#include "coupling/parameters/parameter_problems.h"

namespace interlock::coupling
{
// Entries that say what a product says, or that are missing without one; a product that cannot be;
// then a slot, a box or a cut that the ribs do not fit, and edges that are too round. A lattice
// file is not looked at (lay_geogrid does).
void check_geogrid(const GeogridParameters& geogrid, const BoxParameters& box,
                   ParameterProblems& problems);

// Of its whole apertures, from the first transverse rib to the last one [m].
double length_of_geogrid(const GeogridParameters& geogrid);
} // namespace interlock::coupling
