// Beams and options that several tests of statics use.
#pragma once

#include "fem/statics/static_solver.h"

// Bending stiffness 1 in both planes; stretch and shear stiffness as given, by default so stiff
// that on a unit length both stay below 1e-6.
inline interlock::fem::BeamSection slender(double stretch = 1e7)
{
  interlock::fem::BeamSection section;
  section.axial = section.shear_2 = section.shear_3 = stretch;
  section.torsion = section.bending_2 = section.bending_3 = 1;
  section.line_density = 1;
  return section;
}

// The whole load at once.
inline interlock::fem::StaticOptions one_step()
{
  interlock::fem::StaticOptions options;
  options.load_steps = 1;
  return options;
}
