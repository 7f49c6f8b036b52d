// Everything that a shear box run reads from its parameter file. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/filling_parameters.h"
#include "coupling/parameters/output_parameters.h"
#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_parameters.h"
#include "coupling/parameters/time_step.h"

namespace interlock::coupling
{
struct ShearParameters {
  double speed = 0;     // of the lower half [m/s]
  double distance = 0;  // [m]
  double ramp_time = 0; // from rest to full speed [s]
};

struct ShearBoxParameters {
  double gravity = 9.81; // along -z [m/s2]
  StoneParameters stones;
  BoxParameters box; // both halves together; without a slot
  double gap = 0;    // between the halves [m]
  // Between stones and floor or plate; -1: that of the other walls [-].
  double floor_and_plate_friction = -1;
  double normal_stress = 0; // on the plane between the halves, weight of the stones included [Pa]
  // The same while the stones have the friction of the filling; 0: as in the test [Pa].
  double compaction_stress = 0;
  StoneContactParameters contact;
  FillingParameters filling;
  ShearParameters shear;
  TimeParameters time;
  LimitParameters limits;
  OutputParameters output;
};
} // namespace interlock::coupling
