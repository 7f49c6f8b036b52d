// The stones of a run as shapes of its engine, and what is to be said about all of them.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/stones/stone_shapes.h"
#include "dem/bodies/clumps.h"

#include <cstdint>
#include <string>
#include <vector>

namespace interlock::coupling
{
struct StoneBatch {
  int shapes = 0;
  double mean_size = 0;          // diameter of the ball of equal mean volume [m]
  double mean_sphere_radius = 0; // of all member spheres [m]
  std::string text;              // how many and how good, for the log
  std::vector<std::string> warnings;
};

// Adds their shapes behind those that are there.
StoneBatch add_shapes(const std::vector<Stone>& stones, dem::Clumps& clumps);

// Of the shapes of an engine.
double mean_spheres(const dem::Clumps& clumps);
// How many stones of these shapes fill a volume [m3], for forecasts.
std::int64_t expected_stones(const dem::Clumps& clumps, double volume);

// Stones are poured in any attitude, their bounding balls clear of the walls. Throws InputError
// when one is too large for that.
void check_stones_fit(const std::vector<Stone>& stones, const BoxParameters& box);
} // namespace interlock::coupling
