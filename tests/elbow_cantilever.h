// The right-angle cantilever of Simo & Vu-Quoc, CMAME 66 (1988) 125-161, in the units of the paper.
#pragma once

#include "fem/lattice/lattice.h"

#include <algorithm>
#include <cmath>

// First leg along y from the clamp at the origin, second leg along x, 10 long each.
inline interlock::fem::Lattice elbow_lattice(int elements)
{
  using namespace interlock::fem;
  BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = 1e6;
  section.torsion = section.bending_2 = section.bending_3 = 1e3;
  section.line_density = 1;
  section.rotary_1 = 20;
  section.rotary_2 = section.rotary_3 = 10;
  return Lattice({straight_line({0, 0, 0}, {0, 10, 0}, elements, section),
                  straight_line({0, 10, 0}, {10, 10, 0}, elements, section)});
}

// Along z on the elbow: 0 to 50 at t = 1, back to 0 at t = 2.
inline double elbow_force(double t)
{
  return 50 * std::max(0., 1 - std::abs(t - 1));
}
