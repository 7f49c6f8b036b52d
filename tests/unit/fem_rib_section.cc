// Section constants of a rectangle against tables. Fails when a formula or an axis is mixed up.
#include "fem/ribs/beam_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace
{
using namespace interlock::fem;

RibSection rectangle(double width, double thickness)
{
  return {width, thickness, 2.4e9, 0.4, 910};
}

// Timoshenko & Goodier, Theory of Elasticity, art. 109, table of k1 in J = k1 (2a)^3 (2b).
TEST(RibSection, TorsionConstantMatchesTheTable)
{
  const double side = 3e-3;
  const double table[][2] = {{1, 0.1406}, {1.2, 0.166}, {1.5, 0.196}, {2, 0.229}, {2.5, 0.249},
                             {3, 0.263},  {4, 0.281},   {5, 0.291},   {10, 0.312}};
  for (const auto& [ratio, factor] : table) {
    const double unit = ratio * std::pow(side, 4);
    EXPECT_NEAR(torsion_constant(rectangle(ratio * side, side)) / unit, factor, 6e-4);
    EXPECT_NEAR(torsion_constant(rectangle(side, ratio * side)) / unit, factor, 6e-4);
  }
  // A thin strip: one third, less 0.630 thickness/width.
  EXPECT_NEAR(torsion_constant(rectangle(1000 * side, side)) / (1000 * std::pow(side, 4)),
              (1 - 0.63025 / 1000) / 3, 1e-7);
}

TEST(RibSection, BendingAxesAreNotMixedUp)
{
  const RibSection rib = rectangle(5e-3, 2.5e-3); // wide in the plane, thin out of it
  const BeamSection beam = beam_section(rib);
  EXPECT_NEAR(beam.bending_2, 2.4e9 * 5e-3 * std::pow(2.5e-3, 3) / 12, 1e-12);
  EXPECT_NEAR(beam.bending_3, 2.4e9 * 2.5e-3 * std::pow(5e-3, 3) / 12, 1e-12);
  EXPECT_NEAR(beam.axial, 2.4e9 * 12.5e-6, 1e-6);
  EXPECT_NEAR(beam.line_density, 910 * 12.5e-6, 1e-12);
  EXPECT_NEAR(beam.rotary_1, beam.rotary_2 + beam.rotary_3, 1e-18);
}

// Cowper (1966): 5/6 at nu = 0, 0.850 at nu = 0.3.
TEST(RibSection, ShearFactorMatchesCowper)
{
  RibSection rib = rectangle(1, 1);
  for (const auto& [nu, factor] : {std::pair{0., 5. / 6}, {0.3, 0.850}}) {
    rib.poisson_ratio = nu;
    EXPECT_NEAR(shear_area(rib), factor, 5e-4);
  }
}

// A = pi d^2/4, I = pi d^4/64, J = 2 I; Cowper's table gives 0.886 at nu = 0.3.
TEST(RibSection, CircleMatchesTheFormulae)
{
  const double d = 4e-3;
  RibSection bar = round_section(d, 2.4e9, 0.4, 910);
  EXPECT_NEAR(area(bar), M_PI * d * d / 4, 1e-20);
  EXPECT_NEAR(second_moment_2(bar), M_PI * std::pow(d, 4) / 64, 1e-26);
  EXPECT_NEAR(second_moment_3(bar), M_PI * std::pow(d, 4) / 64, 1e-26);
  EXPECT_NEAR(torsion_constant(bar), M_PI * std::pow(d, 4) / 32, 1e-26);
  for (const auto& [nu, factor] : {std::pair{0., 6. / 7}, {0.3, 0.886}, {0.5, 0.900}}) {
    bar.poisson_ratio = nu;
    EXPECT_NEAR(shear_area(bar) / area(bar), factor, 5e-4);
  }
  // Torsion and bending of a circle: G J/(E I) = 1/(1 + nu).
  bar.poisson_ratio = 0.4;
  const BeamSection beam = beam_section(bar);
  EXPECT_NEAR(beam.torsion / beam.bending_2, 1 / 1.4, 1e-12);
  EXPECT_NEAR(beam.line_density, 910 * M_PI * d * d / 4, 1e-15);
  bar.width = 5e-3;
  EXPECT_THROW(beam_section(bar), std::invalid_argument);
}

// A homogeneous section given by its stiffnesses gets the rotary inertia of its shape.
TEST(RibSection, GivenStiffnessesAreCompleted)
{
  const BeamSection rib = beam_section(rectangle(5e-3, 2.5e-3));
  BeamSection given = rib;
  given.rotary_1 = given.rotary_2 = given.rotary_3 = 0;
  const BeamSection complete = given_section(given);
  EXPECT_NEAR(complete.rotary_1, rib.rotary_1, 1e-14 * rib.rotary_1);
  EXPECT_NEAR(complete.rotary_2, rib.rotary_2, 1e-14 * rib.rotary_2);
  EXPECT_NEAR(complete.rotary_3, rib.rotary_3, 1e-14 * rib.rotary_3);
  EXPECT_EQ(given_section(rib).rotary_1, rib.rotary_1);
}

TEST(RibSection, RefusesWhatIsNoRib)
{
  EXPECT_THROW(beam_section(rectangle(0, 1e-3)), std::invalid_argument);
  RibSection rib = rectangle(5e-3, 2.5e-3);
  rib.poisson_ratio = 0.6;
  EXPECT_THROW(beam_section(rib), std::invalid_argument);
}
} // namespace
