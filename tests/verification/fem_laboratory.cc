// The virtual laboratory against closed formulae: tension against EA/pitch, aperture stability of a
// 2 x 2 lattice against slope-deflection theory, the overhang against the heavy elastica. Fails
// when a specimen is held wrongly, a width or a pitch is mixed up between the directions, a rib is
// counted twice, or weight goes missing.
#include "fem/laboratory/laboratory.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace interlock::fem;

namespace
{
RibProfile ribs(double width, double thickness, double density)
{
  RibProfile result;
  result.shape = {width, thickness, 2e9, 0.4, density};
  result.section = beam_section(result.shape);
  return result;
}

// Different in both directions.
GeogridProduct product()
{
  GeogridProduct p;
  p.pitch_along = 0.028;
  p.pitch_across = 0.036;
  p.ribs_along = ribs(0.003, 0.00076, 910);
  p.ribs_across = ribs(0.004, 0.001, 910);
  return p;
}
} // namespace

TEST(Laboratory, TensionIsThatOfTheRibs)
{
  const GeogridProduct p = product();
  const double along = p.ribs_along.section.axial / p.pitch_across,
               across = p.ribs_across.section.axial / p.pitch_along;
  const LaboratoryTest wide = wide_width_tension(p, 0.05, 5),
                       wide_across = wide_width_tension(turned(p), 0.05, 5),
                       single = single_rib_tension(p, 0.05, 5);
  for (const double strain : {0.02, 0.05}) {
    EXPECT_NEAR(load_at(wide.path, strain), strain * along, 1e-6 * strain * along);
    EXPECT_NEAR(load_at(single.path, strain), strain * along, 1e-6 * strain * along);
    EXPECT_NEAR(load_at(wide_across.path, strain), strain * across, 1e-6 * strain * across);
  }
  EXPECT_THROW(load_at(wide.path, 0.06), std::invalid_argument);
}

// Four ribs that are built in at their far ends turn at the middle: with shear, EI/a (4 + f)/(1 +
// f) each, f = 12 EI/(GA a^2).
TEST(Laboratory, ApertureStabilityOfFourRibs)
{
  GeogridProduct p = product();
  p.pitch_along = 0.11;
  p.pitch_across = 0.12;
  const auto stiffness = [](const BeamSection& s, double a) {
    const double f = 12 * s.bending_3 / (s.shear_2 * a * a);
    return 2 * s.bending_3 / a * (4 + f) / (1 + f);
  };
  const double expected = stiffness(p.ribs_along.section, p.pitch_along) +
                          stiffness(p.ribs_across.section, p.pitch_across);
  const LaboratoryTest test = aperture_stability(p, 1e-4 * expected, 2);
  EXPECT_NEAR(test.path.back().load / test.path.back().deformation / expected, 1, 1e-6);
}

// Tension along the ribs does not feel the springs of the junctions; a torque does.
TEST(Laboratory, SemiRigidJunctions)
{
  GeogridProduct p = product();
  p.junction_stiffness.in_plane = 0.5;
  const double along = p.ribs_along.section.axial / p.pitch_across;
  EXPECT_NEAR(load_at(wide_width_tension(p, 0.02, 1).path, 0.02), 0.02 * along, 1e-6 * along);

  // 2 x 2: both lines carry half of the torque, each like two clamped ribs; the spring between them
  // turns by what their stiffnesses differ. The path gives the rotation of the first line, which
  // runs along.
  p.pitch_along = 0.11;
  p.pitch_across = 0.12;
  const auto stiffness = [](const BeamSection& s, double a) {
    const double f = 12 * s.bending_3 / (s.shear_2 * a * a);
    return 2 * s.bending_3 / a * (4 + f) / (1 + f);
  };
  const double first = stiffness(p.ribs_along.section, p.pitch_along),
               second = stiffness(p.ribs_across.section, p.pitch_across),
               k = p.junction_stiffness.in_plane, torque = 1e-4 * first;
  // (first + k) r1 - k r2 = T/2, (second + k) r2 - k r1 = T/2
  const double rotation = 0.5 * torque * (second + 2 * k) / ((first + k) * (second + k) - k * k);
  EXPECT_NEAR(aperture_stability(p, torque, 1).path.back().deformation / rotation, 1, 1e-6);
}

// L = 2.00035 (D/w)^(1/3) for a uniform strip, from D theta'' = -w s cos(theta) integrated to
// 1e-12. Nodal weights err with the square of the element length over L: 1/130 squared.
TEST(Laboratory, OverhangFindsTheBendingStiffness)
{
  GeogridProduct p = product();
  p.ribs_across = ribs(0.004, 0.001, 1e-6);
  const double stiffness = p.ribs_along.section.bending_2 / p.pitch_across,
               weight = p.mass_per_area() * 9.81;
  const double expected = 2.0003496915710657 * std::cbrt(stiffness / weight);
  const OverhangResult one = flexural_overhang(p, 1, 9.81), three = flexural_overhang(p, 3, 9.81);
  EXPECT_NEAR(one.length / expected, 1, 2e-4);
  EXPECT_NEAR(one.flexural_rigidity / stiffness, 1, 1e-3);
  EXPECT_NEAR(three.length / expected, 1, 2e-4);
}

// Ribs carry all of the tension, whatever the bars. A triaxial sheet of softly bending ribs has 2
// EA/(sqrt(3) a), between what edges that hinder the contraction add and diagonals that end at the
// sides take away.
TEST(Laboratory, OtherPatterns)
{
  GeogridProduct uniaxial = product();
  uniaxial.pattern = Pattern::uniaxial;
  uniaxial.pitch_along = 0.2;
  uniaxial.ribs_across = ribs(0.016, 0.003, 910);
  const double along = uniaxial.ribs_along.section.axial / uniaxial.pitch_across;
  EXPECT_NEAR(load_at(wide_width_tension(uniaxial, 0.02, 1).path, 0.02), 0.02 * along,
              1e-6 * along);
  EXPECT_THROW(turned(uniaxial), std::invalid_argument);

  GeogridProduct triaxial = product();
  triaxial.pattern = Pattern::triaxial;
  triaxial.pitch_across = 0.046;
  triaxial.pitch_along = std::sqrt(0.75) * triaxial.pitch_across;
  triaxial.ribs_along = triaxial.ribs_across = ribs(0.0012, 0.0016, 910);
  const double sheet =
      triaxial.ribs_along.section.axial / (std::sqrt(0.75) * triaxial.pitch_across);
  const double measured = load_at(wide_width_tension(triaxial, 0.002, 1).path, 0.002) / 0.002;
  EXPECT_LT(measured, 9. / 8 * sheet); // as if no part of the sheet could contract
  EXPECT_GT(measured, 0.7 * sheet);
  EXPECT_THROW(single_rib_tension(triaxial, 0.02, 1), std::invalid_argument);
}

TEST(Laboratory, TurnedProductHasTheSameMass)
{
  const GeogridProduct p = product();
  EXPECT_DOUBLE_EQ(turned(p).mass_per_area(), p.mass_per_area());
  // Two ribs of one aperture each way, per area of an aperture.
  const double one_cell = p.ribs_along.section.line_density * p.pitch_along +
                          p.ribs_across.section.line_density * p.pitch_across;
  EXPECT_NEAR(p.mass_per_area() * p.pitch_along * p.pitch_across, one_cell, 1e-12 * one_cell);
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return RUN_ALL_TESTS();
}
