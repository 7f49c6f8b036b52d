#include "fem/ribs/beam_section.h"

#include "fem/ribs/number_text.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
void require(bool fine, const char* name, double value, const char* allowed)
{
  if (!fine)
    throw std::invalid_argument("The " + std::string(name) + " of a rib is " + number_text(value) +
                                " but must be " + allowed + ".");
}
} // namespace

BeamSection beam_section(const RibSection& rib)
{
  require(rib.width > 0, "width", rib.width, "positive");
  require(rib.thickness > 0, "thickness", rib.thickness, "positive");
  require(rib.youngs_modulus > 0, "Young's modulus", rib.youngs_modulus, "positive");
  require(rib.density > 0, "density", rib.density, "positive");
  require(rib.poisson_ratio > -1 && rib.poisson_ratio <= 0.5, "Poisson's ratio", rib.poisson_ratio,
          "above -1 and at most 0.5");
  if (rib.form == SectionForm::circle)
    require(rib.width == rib.thickness, "thickness", rib.thickness,
            "equal to the width where the rib is round");

  const double shear_modulus = rib.youngs_modulus / (2 * (1 + rib.poisson_ratio));
  const double i2 = second_moment_2(rib), i3 = second_moment_3(rib);
  BeamSection section;
  section.axial = rib.youngs_modulus * area(rib);
  section.shear_2 = section.shear_3 = shear_modulus * shear_area(rib);
  section.torsion = shear_modulus * torsion_constant(rib);
  section.bending_2 = rib.youngs_modulus * i2;
  section.bending_3 = rib.youngs_modulus * i3;
  section.line_density = rib.density * area(rib);
  section.rotary_1 = rib.density * (i2 + i3);
  section.rotary_2 = rib.density * i2;
  section.rotary_3 = rib.density * i3;
  return section;
}

BeamSection given_section(BeamSection section)
{
  const auto require_positive = [](const char* name, double value) {
    require(value > 0 && std::isfinite(value), name, value, "positive and finite");
  };
  require_positive("axial stiffness E A", section.axial);
  require_positive("shear stiffness k G A along e2", section.shear_2);
  require_positive("shear stiffness k G A along e3", section.shear_3);
  require_positive("torsional stiffness G J", section.torsion);
  require_positive("bending stiffness E I about e2", section.bending_2);
  require_positive("bending stiffness E I about e3", section.bending_3);
  require_positive("line density", section.line_density);

  const double per_stiffness = section.line_density / section.axial;
  const auto complete = [](const char* name, double& value, double homogeneous) {
    require(value >= 0 && std::isfinite(value), name, value, "zero or positive");
    if (value == 0) value = homogeneous;
  };
  complete("rotary inertia about e2", section.rotary_2, per_stiffness * section.bending_2);
  complete("rotary inertia about e3", section.rotary_3, per_stiffness * section.bending_3);
  complete("rotary inertia about e1", section.rotary_1, section.rotary_2 + section.rotary_3);
  return section;
}
} // namespace interlock::fem
