// A lattice read as quadratic elements: of each rib line the elements 0 and 1, 2 and 3, ... form
// one.
#pragma once

#include "fem/beam/quadratic_element.h"
#include "fem/lattice/lattice.h"

#include <array>
#include <vector>

namespace interlock::fem
{
// Two consecutive elements of a line as one; pair p are the elements 2p and 2p + 1 of the lattice.
struct QuadraticPair {
  std::array<int, 3> node; // first end, middle, second end
  QuadraticBeam beam;
};

// Curved where the three nodes lie on a curve.
// Throws std::invalid_argument when a line has an odd number of elements, and as `quadratic_beam`.
std::vector<QuadraticPair> quadratic_pairs(const Lattice& lattice);
} // namespace interlock::fem
