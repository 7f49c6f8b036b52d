// The biaxial geogrid in the box. SI units. The comment beside each member repeats the unit of the
// entry in the file.
#pragma once

#include <string>

namespace interlock::coupling
{
struct GeogridParameters {
  bool rigid = false;                  // prescribe every freedom (the paper's geogrid)
  std::string placement = "flattened"; // flattened | not flattened
  int apertures_along = 0;             // in the direction of the pull
  int apertures_across = 0;
  double overhang = 0;       // of the clamped front rib, from the front wall to its near edge [m]
  double pitch_along = 0;    // rib centre line to rib centre line [m]
  double pitch_across = 0;   // [m]
  double rib_width = 0;      // in plane [m]
  double rib_thickness = 0;  // out of plane [m]
  double edge_rounding = 0;  // radius of the rounded edges, at most half the thickness [m]
  double youngs_modulus = 0; // [Pa]
  double poisson_ratio = 0;  // [-]
  double density = 0;        // [kg/m3]
  int elements_per_rib = 8;  // between two junctions
  double mass_damping = 0;   // force = mass_damping * mass * velocity [1/s]
  double break_strain = 0;   // of a rib in tension, where the run ends; 0: ribs do not break [-]
};
} // namespace interlock::coupling
