#include "fem/ribs/rib_section.h"

#include <algorithm>
#include <cmath>

namespace interlock::fem
{
namespace
{
bool is_round(const RibSection& section)
{
  return section.form == SectionForm::circle;
}

// About a diameter.
double second_moment_of_circle(double diameter)
{
  return M_PI * std::pow(diameter, 4) / 64;
}

double torsion_constant_of_rectangle(const RibSection& section)
{
  const double a = std::max(section.width, section.thickness);
  const double b = std::min(section.width, section.thickness);
  // Terms fall as n^-5: the first one left out, n = 401, is below 1e-13 of the sum.
  double sum = 0;
  for (int n = 399; n >= 1; n -= 2) sum += std::tanh(n * M_PI * a / (2 * b)) / std::pow(n, 5);
  return a * b * b * b / 3 * (1 - 192 / std::pow(M_PI, 5) * (b / a) * sum);
}
} // namespace

RibSection round_section(double diameter, double youngs_modulus, double poisson_ratio,
                         double density)
{
  return {diameter, diameter, youngs_modulus, poisson_ratio, density, SectionForm::circle};
}

double area(const RibSection& section)
{
  const double box = section.width * section.thickness;
  return is_round(section) ? M_PI / 4 * box : box;
}

double second_moment_2(const RibSection& section)
{
  if (is_round(section)) return second_moment_of_circle(section.thickness);
  return section.width * std::pow(section.thickness, 3) / 12;
}

double second_moment_3(const RibSection& section)
{
  if (is_round(section)) return second_moment_of_circle(section.width);
  return section.thickness * std::pow(section.width, 3) / 12;
}

double torsion_constant(const RibSection& section)
{
  if (is_round(section)) return 2 * second_moment_of_circle(section.width);
  return torsion_constant_of_rectangle(section);
}

double shear_area(const RibSection& section)
{
  const double nu = section.poisson_ratio;
  const double factor =
      is_round(section) ? 6 * (1 + nu) / (7 + 6 * nu) : 10 * (1 + nu) / (12 + 11 * nu);
  return factor * area(section);
}
} // namespace interlock::fem
