// Everything that a triaxial run reads from its parameter file. SI units. The comment beside each
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
struct CompressionParameters {
  double strain_rate = 0; // speed of the plate over the height when the compression begins [1/s]
  double strain = 0;      // axial, at the end, of that height [-]
  double ramp_time = 0;   // from rest to full speed [s]
};

struct TriaxialParameters {
  double gravity = 9.81; // along -z, until the plate lies on the stones [m/s2]
  StoneParameters stones;
  BoxParameters box;        // that the stones are poured into; without a slot
  double cell_pressure = 0; // on the sides, and on the plate until the compression [Pa]
  // The same while the stones have the friction of the filling; 0: the cell pressure [Pa].
  double compaction_stress = 0;
  StoneContactParameters contact;
  FillingParameters filling;
  CompressionParameters compression;
  TimeParameters time;
  LimitParameters limits;
  OutputParameters output;
};
} // namespace interlock::coupling
