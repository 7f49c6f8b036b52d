// Everything that a shear box run reads from its parameter file. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/output_parameters.h"
#include "coupling/strength_test/specimen_parameters.h"

namespace interlock::coupling
{
struct ShearParameters {
  double speed = 0;     // of the lower half [m/s]
  double distance = 0;  // [m]
  double ramp_time = 0; // from rest to full speed [s]
};

struct ShearBoxParameters {
  SpecimenParameters specimen; // its box: both halves together
  double gap = 0;              // between the halves [m]
  // Between stones and floor or plate; -1: that of the other walls [-].
  double floor_and_plate_friction = -1;
  double normal_stress = 0; // on the plane between the halves, weight of the stones included [Pa]
  ShearParameters shear;
  OutputParameters output;
};
} // namespace interlock::coupling
