// Pouring stones into a box from above.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "dem/engine/engine.h"

#include <cstdint>
#include <functional>

namespace interlock::coupling
{
// Between bounding balls, and to the walls [m].
constexpr double pouring_clearance = 1e-3;

struct Pouring {
  std::uint64_t seed = 1;     // of the order, places and attitudes of the stones
  double drop_height = 0;     // clear height between the surface and the lowest new stone [m]
  double density = 0;         // of the stones [kg/m3]
  int n_shapes = 0;           // the first shapes of the engine are those of the stones
  std::function<void()> poll; // called for each stone, and may throw: a large box takes long
};

// Puts stones of at least `mass` [kg] above everything that is in the box, at rest, each as low as
// its bounding ball fits: nothing overlaps. Returns the time that the highest one needs to fall
// [s].
//
// What a stone is like follows from the seed and its id alone: its shape (stones come in batches
// that hold every shape once, in random order), its attitude, and the places in plan that it tries.
double pour(dem::Engine& engine, const BoxParameters& box, const Pouring& pouring, double mass);
} // namespace interlock::coupling
