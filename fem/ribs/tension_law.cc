#include "fem/ribs/tension_law.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
void require_positive(const char* name, double value)
{
  if (!(value > 0))
    throw std::invalid_argument("The " + std::string(name) + " of a data sheet is " +
                                std::to_string(value) + " but must be positive.");
}

// Lost while the stretch grew along the envelope: the work below it, less what is stored.
double lost_on_envelope(const TensionLaw& law, double stretch)
{
  const double x = law.softening * stretch, stored = x / (1 + x);
  return law.axial / (law.softening * law.softening) * (x - std::log1p(x) - 0.5 * stored * stored);
}
} // namespace

TensionLaw tension_law(double secant_2, double secant_5, double spacing, double strength)
{
  require_positive("secant stiffness at 2 %", secant_2);
  require_positive("secant stiffness at 5 %", secant_5);
  require_positive("spacing of the ribs", spacing);
  require_positive("strength", strength);
  if (secant_5 > secant_2)
    throw std::invalid_argument("The secant stiffness at 5 % is " + std::to_string(secant_5) +
                                " N/m but must be at most that at 2 %, " +
                                std::to_string(secant_2) +
                                " N/m: ribs that stiffen are not offered.");
  const double force_2 = 0.02 * secant_2, force_5 = 0.05 * secant_5; // per width
  if (!(force_5 > force_2))
    throw std::invalid_argument("The force at 5 % strain is " + std::to_string(force_5) +
                                " N/m but must be above that at 2 %, " + std::to_string(force_2) +
                                " N/m.");
  if (strength < force_5)
    throw std::invalid_argument("The strength is " + std::to_string(strength) +
                                " N/m but must be at least the force at 5 % strain, " +
                                std::to_string(force_5) + " N/m.");
  // EA = J2 (1 + 0.02 s) = J5 (1 + 0.05 s).
  const double softening = (secant_2 - secant_5) / (force_5 - force_2);
  return {spacing * secant_2 * (1 + 0.02 * softening), softening, spacing * strength};
}

double plastic_stretch(const TensionLaw& law, double stretch, double before)
{
  return plastic_stretch(stretch, law.softening, law.yield_force / law.axial, before);
}

double axial_force(const TensionLaw& law, double stretch, double before)
{
  return law.axial * (stretch - plastic_stretch(law, stretch, before));
}

double plastic_work(const TensionLaw& law, double plastic_stretch)
{
  const double a = law.axial, s = law.softening, n = law.yield_force;
  // Where the envelope meets the yield force; never if that lies above the asymptote.
  const double limit =
      n * s < a ? n / (a - n * s) - n / a : std::numeric_limits<double>::infinity();
  const double below = std::min(plastic_stretch, limit);
  double work = 0;
  // On the envelope e_p = s e^2/(1 + s e).
  if (s > 0) work = lost_on_envelope(law, 0.5 * below + std::sqrt(below * (0.25 * below + 1 / s)));
  if (plastic_stretch > limit) work += n * (plastic_stretch - limit);
  return work;
}
} // namespace interlock::fem
