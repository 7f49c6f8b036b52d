#include "coupling/parameters/filling_declarations.h"

#include "coupling/parameters/stone_contact.h"

namespace interlock::coupling
{
void declare_filling(ParameterTable& table, FillingParameters& filling)
{
  table.open_section("Filling");
  table.offer_seed("Seed", filling.seed,
                   "Seed of the order, places and attitudes of the stones in the hopper. [-]");
  table.offer("Stone friction", filling.stone_friction, -1, pair_friction_range,
              "Friction coefficient between stones until the box is full: a low one makes a dense "
              "filling; -1: that of the test. [-]");
  table.require("Drop height", filling.drop_height, not_negative,
                "Clear height between the surface and the lowest new stone. [m]");
  table.require("Plate speed", filling.plate_speed, positive,
                "Largest speed of a plate that presses on the stones. [m/s]");
  table.require("Local damping", filling.local_damping, {0, 1},
                "Share of the unbalanced force taken from stones in contact until the test starts "
                "(Cundall's local damping), so that they settle sooner. [-]");
  table.require("Kinetic energy ratio", filling.kinetic_energy_ratio, positive,
                "Settled, ready for the test, when the kinetic energy is below this share of total "
                "weight x mean stone size; ten times as much is enough between two pours. [-]");
  table.require(
      "Settling time limit", filling.settling_time_limit, positive,
      "A settling stage ends after this simulated time at the latest, with a warning. [s]");
}
} // namespace interlock::coupling
