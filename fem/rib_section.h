// Cross-section of a geogrid rib and its linear elastic stiffnesses.
#pragma once

namespace interlock::fem
{
// A rounded rectangle: `width` along the section's first axis (in the plane of the geogrid), `thickness`
// along the second (out of plane).
struct RibSection {
  double width = 0;          // [m]
  double thickness = 0;      // [m]
  double youngs_modulus = 0; // [Pa]
  double poisson_ratio = 0;  // [-]
  double density = 0;        // [kg/m3]
};
} // namespace interlock::fem
