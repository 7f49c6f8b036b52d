#include "coupling/run/machine_speed.h"

#include "dem/engine/engine.h"

#include <chrono>
#include <cmath>
#include <fstream>

#include <unistd.h>

namespace interlock::coupling
{
namespace
{
constexpr int per_edge = 8;            // balls along an edge of the box
constexpr double radius = 0.01;        // [m]
constexpr double dt = 1e-7;            // so short that nothing leaves its place [s]
constexpr double quiet_step = 12.6e-6; // the best of many on the machine of Forecast [s]
constexpr double least_time = 0.04;    // of the measurement [s]
constexpr int steps_before = 50, chunk = 100;

dem::ClumpShape ball()
{
  dem::ClumpShape shape;
  shape.name = "ball";
  shape.spheres = {{dem::Vector3::Zero(), radius}};
  shape.volume = 4 * M_PI / 3 * std::pow(radius, 3);
  shape.unit_inertia = dem::Vector3::Constant(0.4 * shape.volume * radius * radius);
  return shape;
}

// Balls in a cubic lattice, each of which touches its six neighbours.
dem::Engine packed_box()
{
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 1e6;
  pair.friction = 0.5;
  dem::Engine engine({ball()}, pair, 0);
  constexpr double spacing = 2 * radius * (1 - 1e-6);
  for (int i = 0; i < per_edge; ++i)
    for (int j = 0; j < per_edge; ++j)
      for (int k = 0; k < per_edge; ++k)
        engine.add_clump(0, 2650, spacing * dem::Vector3(i, j, k), dem::Quaternion::Identity());
  return engine;
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
// What this process has in memory now; 0 where the system does not say [bytes].
double resident_memory()
{
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  return file >> all >> resident ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}
} // namespace

double measured_slowness()
{
  dem::Engine engine = packed_box();
  for (int n = 0; n < steps_before; ++n) engine.step(dt);
  const auto start = std::chrono::steady_clock::now();
  int steps = 0;
  double elapsed = 0;
  while (elapsed < least_time) {
    for (int n = 0; n < chunk; ++n) engine.step(dt);
    steps += chunk;
    elapsed = seconds_since(start);
  }
  return elapsed / steps / quiet_step;
}

void measure_machine(Forecast& forecast)
{
  forecast.slowness = measured_slowness();
  if (const double memory = resident_memory(); memory > 0) forecast.program_memory = memory;
}
} // namespace interlock::coupling
