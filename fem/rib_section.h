// Cross-section of a geogrid rib, and the constants of a rectangle that beam theory needs.
#pragma once

namespace interlock::fem
{
// A rectangle: `width` along the section's axis e2 (in the plane of the geogrid), `thickness` along
// e3 (out of plane); e1 runs along the rib. Rounded edges matter to contacts only; the stiffnesses
// below are those of the full rectangle.
struct RibSection {
  double width = 0;          // [m]
  double thickness = 0;      // [m]
  double youngs_modulus = 0; // [Pa]
  double poisson_ratio = 0;  // [-]
  double density = 0;        // [kg/m3]
};

// Area of the rectangle [m2].
double area(const RibSection& section);

// Second moment of area [m4] for out-of-plane bending, about e2: width * thickness^3 / 12.
double second_moment_2(const RibSection& section);

// Second moment of area [m4] for in-plane bending, about e3: thickness * width^3 / 12.
double second_moment_3(const RibSection& section);

// St Venant torsion constant [m4] of the rectangle with sides a >= b,
//   a b^3/3 [1 - (192/pi^5) (b/a) sum over odd n of tanh(n pi a/(2 b))/n^5]
// (Timoshenko & Goodier, Theory of Elasticity, 3rd ed., art. 109). Warping is free.
double torsion_constant(const RibSection& section);

// Shear area [m2], the same in both directions: k * area with Cowper's factor for a rectangle,
// k = 10 (1 + nu)/(12 + 11 nu) (J. Appl. Mech. 33 (1966) 335-340); 5/6 at nu = 0.
double shear_area(const RibSection& section);
} // namespace interlock::fem
