// The geogrid in the box: a product, a drawing, or a biaxial one by the entries here. SI units. The
// comment beside each member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/product_parameters.h"

#include <optional>
#include <string>

namespace interlock::coupling
{
struct GeogridParameters {
  bool rigid = false;                  // prescribe every freedom (the paper's geogrid)
  std::string placement = "flattened"; // flattened | not flattened
  std::string product_file; // that `product` was read from; empty: none, or its values are known
  // Instead of pitches, section, material and elements of the entries below.
  std::optional<ProductParameters> product;
  std::string lattice_file;       // .msh with the ribs of the product or the entries; empty: none
  double lattice_length_unit = 1; // of that file [m]
  int apertures_along = 0;        // in the direction of the pull
  int apertures_across = 0;
  double cut_width = 0;      // to which ribs go on beside the last apertures; 0: not at all [m]
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
