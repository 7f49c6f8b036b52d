// What a product file says of a geogrid (cases/geogrids): the section "Product". SI units.
#pragma once

#include <string>

namespace interlock::coupling
{
// Ribs of one direction.
struct ProductRibsParameters {
  double width = 0;          // in the plane of the geogrid [m]
  double thickness = 0;      // [m]
  double youngs_modulus = 0; // 0: from the secant stiffness [Pa]
  // Of the sheet, force per width over strain [N/m]; 0: linear, from the modulus.
  double stiffness_2 = 0; // at 2 % strain
  double stiffness_5 = 0; // at 5 % strain; 0: that at 2 %
  double strength = 0;    // largest force per width [N/m]; 0: no yield
};

struct ProductParameters {
  std::string name;
  std::string pattern = "biaxial"; // or uniaxial, triaxial
  double pitch_along = 0;          // of the ribs that run across, centre to centre [m]
  double pitch_across = 0;         // of the ribs that run along [m]
  ProductRibsParameters along, across;
  double poisson_ratio = 0;  // [-]
  double density = 0;        // [kg/m3]
  double junction_reach = 0; // distance from a junction up to which ribs are thicker; 0: none [m]
  double junction_thickness = 0; // of the ribs there [m]
  double junction_stiffness = 0; // in the plane, between ribs that cross; 0: rigid [N m/rad]
  int elements_per_rib = 8;
};
} // namespace interlock::coupling
