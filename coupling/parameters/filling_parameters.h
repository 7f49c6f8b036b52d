// How stones are poured, levelled and settled. SI units. The comment beside each member repeats the
// unit of the entry in the file.
#pragma once

#include <cstdint>

namespace interlock::coupling
{
struct FillingParameters {
  std::uint64_t seed = 1; // of the order, places and attitudes of the stones
  // Between stones until the box is full; -1: that of the test [-].
  double stone_friction = -1;
  double drop_height = 0;       // clear height between the surface and the lowest new stone [m]
  double plate_speed = 0;       // of the flattening plate [m/s]
  double plate_force_limit = 0; // the plate stops pressing there [N]
  // Mass that is poured for each half of the box over its volume, after which a plate presses the
  // surface level; 0: as much as fills it [kg/m3].
  double lower_bulk_density = 0, upper_bulk_density = 0;
  double local_damping = 0; // of stones in contact, until the pull starts [-]
  // Settled before the pull when E_kin < ratio * total weight * mean stone size [-].
  double kinetic_energy_ratio = 0;
  double settling_time_limit = 0; // each settling stage ends there, with a warning [s]
};
} // namespace interlock::coupling
