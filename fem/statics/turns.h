// Turns by which a load step may have gone astray.
#pragma once

#include "fem/statics/static_state.h"

namespace interlock::fem
{
// Largest angle by which a node turns between two states of one lattice [rad].
double largest_turn(const StaticState& from, const StaticState& to);

// The element whose ends turn most against each other, and by how much [rad].
struct SharpestElement {
  int element = 0;
  double turn = 0;
};
SharpestElement sharpest_element(const StaticState& state);

// What the element's kernel is good for (beam_element.h) [rad].
constexpr double largest_element_turn = 2.5;
} // namespace interlock::fem
