// Everything that a triaxial run reads from its parameter file. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/output_parameters.h"
#include "coupling/strength_test/specimen_parameters.h"

namespace interlock::coupling
{
struct CompressionParameters {
  double strain_rate = 0; // speed of the plate over the height when the compression begins [1/s]
  double strain = 0;      // axial, at the end, of that height [-]
  double ramp_time = 0;   // from rest to full speed [s]
};

struct TriaxialParameters {
  SpecimenParameters specimen; // its gravity acts until the plate lies on the stones
  double cell_pressure = 0;    // on the sides, and on the plate until the compression [Pa]
  CompressionParameters compression;
  OutputParameters output;
};
} // namespace interlock::coupling
