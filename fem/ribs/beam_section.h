// The six stiffnesses and the inertia per length that the beam element works with.
#pragma once

#include "fem/ribs/rib_section.h"

#include <limits>

namespace interlock::fem
{
// Section laws in the element's frame (e1 along the beam): axial force N = axial * stretch, shear
// V_i = shear_i * shear strain, torque T = torsion * twist, moments M_i = bending_i * curvature
// about e_i. All linear elastic, but tension may soften and yield (tension_law.h). Any beam can be
// given; `beam_section` fills it for a rib.
struct BeamSection {
  double axial = 0;        // E A [N]
  double shear_2 = 0;      // k G A along e2 [N]
  double shear_3 = 0;      // k G A along e3 [N]
  double torsion = 0;      // G J [N m2]
  double bending_2 = 0;    // E I about e2, out-of-plane bending [N m2]
  double bending_3 = 0;    // E I about e3, in-plane bending [N m2]
  double line_density = 0; // rho A [kg/m]
  double rotary_1 = 0;     // rho (I2 + I3) [kg m]
  double rotary_2 = 0;     // rho I2 [kg m]
  double rotary_3 = 0;     // rho I3 [kg m]
  double softening = 0;    // s of TensionLaw [-]
  double yield_force = std::numeric_limits<double>::infinity(); // N_y of TensionLaw [N]
};

// Section laws of a rib of rectangular or circular cross-section.
// Throws std::invalid_argument when a size, Young's modulus or the density is not positive,
// Poisson's ratio is outside (-1, 0.5], or width and thickness of a circle differ.
BeamSection beam_section(const RibSection& rib);

// Section laws as measured or as a product sheet gives them. Rotary inertias that are zero become
// those of a homogeneous section, rho I = rho A (E I)/(E A) about e2 and e3 and their sum about e1.
// Throws std::invalid_argument when a stiffness or the line density is not positive and finite or a
// rotary inertia is negative.
BeamSection given_section(BeamSection section);

// Shear stiffness [N] of one element with the residual bending flexibility of its plane,
// 1/S* = 1/S + h^2/(12 EI) (MacNeal, Computers & Structures 8 (1978) 175-183): it gives the
// two-node one-point element the exact deflection of a straight span at small load. `bending` is
// the stiffness about the axis normal to the shear direction, `length` the length of the element
// [m].
inline double residual_shear(double shear, double bending, double length)
{
  return 1 / (1 / shear + length * length / (12 * bending));
}

// Bowing b of such an element [-]: its axial force acts on the stretch + b g^2/2 + (h^2/12) k^2/2,
// with shear strain g and curvature k of each plane. The axial strain of one point lacks the bow
// between the nodes:
// * The share s = S*h^2/(12 EI) of the shear strain is bending in truth, a cubic between both nodes
//   that is (s g)^2/10 longer than the chord and leaves (1 - s) g as angle between section and
//   centre line; so b = s (2 - 4 s/5).
// * The arc of curvature k is (k h)^2/24 longer than its chord.
// Without it sections would tip over as soon as the tension exceeds S*; with it the element
// converges with the fourth order where shear is small, for ribs that were straight and bend in a
// plane. Where they were curved, and out of the plane of a bent rib, the order is two: the bow is
// not coupled to the twist that goes with it (docs/theory/geogrid.md).
inline double residual_bowing(double shear, double bending, double length)
{
  const double share = 1 / (1 + 12 * bending / (shear * length * length));
  return share * (2 - 0.8 * share);
}
} // namespace interlock::fem
