#include "dem/stones/roughness.h"

namespace interlock::dem
{
Roughness::Roughness(const StoneStyle& style, double longest, double shortest, RandomStream& random)
{
  constexpr int waves_per_octave = 12;
  for (double octave = longest; octave > shortest; octave /= 2) {
    const double rms = style.roughness * std::pow(octave / 0.010, style.roughness_exponent);
    for (int k = 0; k < waves_per_octave; ++k) {
      const double length = octave * random.uniform(0.7, 1.4);
      const Vector3 direction = random.direction();
      // n waves of amplitude a have the mean square n a^2/2.
      waves_.push_back({2 * M_PI / length * direction, random.uniform(0, 2 * M_PI),
                        rms * std::sqrt(2. / waves_per_octave)});
    }
  }
}

double Roughness::height(const Vector3& x) const
{
  double sum = 0;
  for (const Wave& wave : waves_) sum += wave.amplitude * std::sin(wave.number.dot(x) + wave.phase);
  return sum;
}
} // namespace interlock::dem
