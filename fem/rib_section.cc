#include "fem/rib_section.h"

#include <algorithm>
#include <cmath>

namespace interlock::fem
{
double area(const RibSection& section)
{
  return section.width * section.thickness;
}

double second_moment_2(const RibSection& section)
{
  return section.width * std::pow(section.thickness, 3) / 12;
}

double second_moment_3(const RibSection& section)
{
  return section.thickness * std::pow(section.width, 3) / 12;
}

double torsion_constant(const RibSection& section)
{
  const double a = std::max(section.width, section.thickness);
  const double b = std::min(section.width, section.thickness);
  // Terms fall as n^-5: the first one left out, n = 401, is below 1e-13 of the sum.
  double sum = 0;
  for (int n = 399; n >= 1; n -= 2) sum += std::tanh(n * M_PI * a / (2 * b)) / std::pow(n, 5);
  return a * b * b * b / 3 * (1 - 192 / std::pow(M_PI, 5) * (b / a) * sum);
}

double shear_area(const RibSection& section)
{
  const double nu = section.poisson_ratio;
  return 10 * (1 + nu) / (12 + 11 * nu) * area(section);
}
} // namespace interlock::fem
