// Cross-section of a geogrid rib, and the constants of it that beam theory needs.
#pragma once

namespace interlock::fem
{
enum class SectionForm { rectangle, circle };

// `width` along the section's axis e2 (in the plane of the geogrid), `thickness` along e3 (out of
// plane); e1 runs along the rib. A circle has its diameter in both. Rounded edges of a rectangle
// matter to contacts only; the stiffnesses below are those of the full rectangle.
struct RibSection {
  double width = 0;          // [m]
  double thickness = 0;      // [m]
  double youngs_modulus = 0; // [Pa]
  double poisson_ratio = 0;  // [-]
  double density = 0;        // [kg/m3]
  SectionForm form = SectionForm::rectangle;
};

// A round rib, such as a bar or a yarn.
RibSection round_section(double diameter, double youngs_modulus, double poisson_ratio,
                         double density);

// Area [m2]: width * thickness, or pi d^2/4.
double area(const RibSection& section);

// Second moment of area [m4] for out-of-plane bending, about e2: width * thickness^3 / 12, or
// pi d^4/64.
double second_moment_2(const RibSection& section);

// Second moment of area [m4] for in-plane bending, about e3: thickness * width^3 / 12, or
// pi d^4/64.
double second_moment_3(const RibSection& section);

// St Venant torsion constant [m4]: of a circle pi d^4/32, of the rectangle with sides a >= b
//   a b^3/3 [1 - (192/pi^5) (b/a) sum over odd n of tanh(n pi a/(2 b))/n^5]
// (Timoshenko & Goodier, Theory of Elasticity, 3rd ed., art. 109). Warping is free.
double torsion_constant(const RibSection& section);

// Shear area [m2], the same in both directions: k * area with Cowper's factor (J. Appl.
// Mech. 33 (1966) 335-340): for a rectangle k = 10 (1 + nu)/(12 + 11 nu), 5/6 at nu = 0; for a
// circle k = 6 (1 + nu)/(7 + 6 nu), 6/7 at nu = 0.
double shear_area(const RibSection& section);
} // namespace interlock::fem
