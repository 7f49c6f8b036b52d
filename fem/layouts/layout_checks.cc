#include "fem/layouts/layout_checks.h"

#include "fem/ribs/number_text.h"

#include <cmath>
#include <stdexcept>

namespace interlock::fem
{
void require_positive(double value, const char* name)
{
  if (!(value > 0 && std::isfinite(value)))
    throw std::invalid_argument("The " + std::string(name) + " of a geogrid is " +
                                number_text(value) + " but must be positive.");
}

void require_gap(double width, double pitch, const char* name)
{
  if (!(width < pitch))
    throw std::invalid_argument("The " + std::string(name) + " of a geogrid is " +
                                number_text(width) + " m but must be below their pitch of " +
                                number_text(pitch) + " m, or ribs overlap.");
}
} // namespace interlock::fem
