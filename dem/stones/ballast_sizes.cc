#include "dem/stones/ballast_sizes.h"

#include <array>
#include <cmath>

namespace interlock::dem
{
std::vector<double> ballast_sizes(int count)
{
  struct Class {
    double low, high, mass_share;
  };
  // Table 5. Stones far below 18 mm would be many and weigh nothing.
  constexpr std::array<Class, 5> classes{
      {{18, 22, 1}, {22, 32, 18}, {32, 40, 44}, {40, 50, 32}, {50, 63, 5}}};
  // Mass is spread evenly over the sizes of a class, so the number density is share/width / d^3,
  // and its integral from `low` to d is share/width (1/low^2 - 1/d^2)/2.
  const auto number = [](const Class& c, double d) {
    return c.mass_share / (c.high - c.low) * (1 / (c.low * c.low) - 1 / (d * d)) / 2;
  };
  double total = 0;
  for (const Class& c : classes) total += number(c, c.high);

  std::vector<double> sizes;
  for (int i = 0; i < count; ++i) {
    double rest = (i + 0.5) / count * total;
    auto c = classes.begin();
    for (; c + 1 != classes.end() && rest > number(*c, c->high); ++c) rest -= number(*c, c->high);
    const double inverse_square =
        1 / (c->low * c->low) - 2 * rest * (c->high - c->low) / c->mass_share;
    sizes.push_back(1e-3 / std::sqrt(inverse_square));
  }
  return sizes;
}
} // namespace interlock::dem
