// Where the stones of a run come from and how clumps are made of them. SI units. The comment beside
// each member repeats the unit of the entry in the file.
#pragma once

#include <cstdint>
#include <string>

namespace interlock::coupling
{
struct StoneParameters {
  std::string folder;     // scans (STL, PLY, OBJ); empty: synthetic stones
  double length_unit = 1; // of the scans: length of one file unit [m]
  int count = 41;         // synthetic stones in one batch
  std::uint64_t seed = 1; // of the synthetic stones and of the random order of the nodes
  double density = 0;     // [kg/m3]
  double d_min = 0;       // clump generator [m]
  double r_min = 0;       // clump generator [m]
  double p_max = 0;       // clump generator [%]
  int max_spheres = 0;    // clump generator; 0: no limit
  std::string sphere_order = "random";  // clump generator: random | gain
  double bulge = 0;                     // clump generator: at most this [m]
  std::string mass_properties = "mesh"; // uniform | equal-mass | mesh
};
} // namespace interlock::coupling
