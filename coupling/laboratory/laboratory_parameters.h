// Everything that a laboratory test of a geogrid reads from its parameter file. SI units but for
// the data sheet, which keeps the units of data sheets.
#pragma once

#include "coupling/parameters/product_parameters.h"

#include <string>

namespace interlock::coupling
{
struct LaboratoryTestParameters {
  std::string test = "data sheet"; // or one test
  std::string direction = "along"; // of tension and overhang in a single test
  double largest_strain = 0;       // of tension [-]
  double largest_torque = 0;       // of aperture stability [N m]
  int steps = 0;                   // of a path
  int strip_ribs = 0;              // width of the overhanging strip
  double gravity = 0;              // [m/s2]
  // Of supports and loads, and of modes.
  int apertures_along = 0, apertures_across = 0; // of the piece
  std::string lattice_file;                      // .msh instead of a piece; empty: none
  double lattice_length_unit = 0;                // of that file [m]
  std::string supports, loads;                   // node_conditions.h
  int modes = 0;                                 // number of frequencies
};

// What the manufacturer states; 0: not stated. Printed beside what was measured, never used.
struct DataSheetParameters {
  std::string source;
  double force_2_along = 0, force_2_across = 0; // at 2 % strain [kN/m]
  double force_5_along = 0, force_5_across = 0; // at 5 % strain [kN/m]
  double aperture_stability = 0;                // [N m/deg]
  double flexural_rigidity = 0;                 // along [mg cm]
  double mass_per_area = 0;                     // [kg/m2]
};

struct LaboratoryParameters {
  ProductParameters product;
  LaboratoryTestParameters test;
  DataSheetParameters data_sheet;
  bool report = true; // figures at the end
};
} // namespace interlock::coupling
