// The roughness of fracture surfaces: a self-affine relief of random waves.
#pragma once

#include "dem/random_stream.h"
#include "dem/stones/stone_style.h"

namespace interlock::dem
{
// Octaves of plane waves in random directions of space, with the heights that StoneStyle has for
// their lengths. Octaves are drawn from long to short, so a smaller `shortest` adds waves and
// changes none. Lengths in m.
class Roughness
{
public:
  Roughness(const StoneStyle& style, double longest, double shortest, RandomStream& random);

  double height(const Vector3& x) const; // [m]

private:
  struct Wave {
    Vector3 number; // [rad/m]
    double phase, amplitude;
  };
  std::vector<Wave> waves_;
};
} // namespace interlock::dem
