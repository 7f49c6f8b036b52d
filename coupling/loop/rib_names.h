// What lines of ribs are called in sentences.
#pragma once

#include "fem/lattice/lattice.h"

#include <string>

namespace interlock::coupling
{
// "transverse rib 2", "longitudinal rib 1", "diagonal rib 5": lines of one kind are counted from 1
// by where they begin in the unloaded lattice, transverse ones along x, others along y and then x.
// Transverse is what runs across, more than 45 degrees from x; longitudinal within 3 degrees of it.
std::string name_of_line(const fem::Lattice& lattice, int line);
} // namespace interlock::coupling
