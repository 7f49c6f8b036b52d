// What a run will take, before it is made: for `interlock check`. Estimates from runs of the cases
// in `cases/` on one core of an AMD EPYC (Zen 4), good to a factor of two.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace interlock::coupling
{
struct StageForecast {
  std::string name;
  double simulated_time = 0; // [s]
  double mean_spheres = 0;   // that are there on average
  bool has_flexible_ribs = false;
};

struct Forecast {
  std::string stones; // what was made of them, a sentence
  std::vector<std::string> warnings;
  std::int64_t clumps = 0, spheres = 0; // at the end
  double time_step = 0;                 // [s]
  std::vector<StageForecast> stages;
  int frames = 0;
  // How many times longer a step takes here than there (machine_speed.h).
  double slowness = 1;
  double program_memory = 1.5e8; // of the program before the stones are there [bytes]

  std::int64_t steps(const StageForecast& stage) const; // of a stage
  // Processor time of a stage [s]: a step costs 1 ns for each sphere, and 28 us for flexible
  // ribs, whose contacts and beams are sub-cycled; times `slowness`.
  double time(const StageForecast& stage) const;
  double time() const;       // of all stages [s]
  double memory() const;     // [bytes]: the program and 2 kB a sphere
  double frame_size() const; // of one when all stones are there [bytes]
  double disk() const;       // [bytes]: frames, states
};
} // namespace interlock::coupling
