// The stones of a run as shapes of its engine, and what is to be said about all of them.
#pragma once

#include "coupling/loop/world.h"
#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/time_step.h"
#include "coupling/stones/stone_shapes.h"

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

// The same, and chooses the step of a world whose stones have this density [kg/m3]; the text says
// what the step is made of, too. Throws InputError when the given step is too long.
StoneBatch add_shapes(const std::vector<Stone>& stones, double density, const TimeParameters& time,
                      World& world);

// Of the shapes of an engine.
double mean_spheres(const dem::Clumps& clumps);
// How many stones of these shapes fill a volume [m3], for forecasts.
std::int64_t expected_stones(const dem::Clumps& clumps, double volume);

// Stones are poured in any attitude, their bounding balls clear of the walls. Throws InputError
// when one is too large for that.
void check_stones_fit(const std::vector<Stone>& stones, const BoxParameters& box);
} // namespace interlock::coupling
