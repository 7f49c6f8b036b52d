// The energy ledger: where every joule of a run went. It closes when what was put in equals what is
// stored plus what was dissipated.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace interlock::dem
{
struct EngineEnergy;
}

namespace interlock::coupling
{
// Errors of a run's ledger over the work put in: beyond the first it warns, beyond the second it
// has failed [-].
constexpr double ledger_bound = 0.01, ledger_failure = 0.1;

// All in J. "Since the start" unless it says now.
struct EnergyLedger {
  double kinetic_stones = 0;   // now
  double kinetic_geogrid = 0;  // now
  double gravitational = 0;    // now, stones and geogrid, zero at the floor
  double elastic_contacts = 0; // now, springs of all contacts
  double elastic_geogrid = 0;  // now, strain energy of the beams
  double friction = 0;         // dissipated by sliding
  double contact_damping = 0;  // dissipated by contact dashpots
  double crushing = 0;         // dissipated where contacts crush
  double local_damping = 0;    // dissipated by local damping of stones while they settle
  double geogrid_damping = 0;  // dissipated by mass damping of the geogrid
  double geogrid_plastic = 0;  // plastic work of ribs that soften or yield
  double clamp_work = 0;       // done by the clamp on the geogrid
  double wall_work = 0;        // done by moving walls on stones
  double inserted = 0;         // of stones and geogrid when they came in, less what was removed
  // Both sides of the interface: what ribs did to stones, what stones did to the lattice. Their sum
  // is minus what the contacts between them store and dissipate.
  double interface_work_on_stones = 0;
  double interface_work_on_geogrid = 0;
  double interface_stored_and_lost = 0;

  // Stored + dissipated - put in; zero for exact arithmetic and an exact integrator.
  double residual() const;
  // The work that was put in: clamp, walls, and the fall of what was inserted.
  double work_put_in() const;
  // |residual| / work put in; 0 before anything was put in.
  double relative_error() const;
  double interface_residual() const
  {
    return interface_work_on_stones + interface_work_on_geogrid + interface_stored_and_lost;
  }

  // Names and values in the order above, for tables and files.
  std::vector<std::pair<std::string, double>> entries() const;
};

template <class Archive> void exchange(Archive& archive, EnergyLedger& ledger)
{
  archive("kinetic_stones", ledger.kinetic_stones, "J");
  archive("kinetic_geogrid", ledger.kinetic_geogrid, "J");
  archive("gravitational", ledger.gravitational, "J");
  archive("elastic_contacts", ledger.elastic_contacts, "J");
  archive("elastic_geogrid", ledger.elastic_geogrid, "J");
  archive("friction", ledger.friction, "J");
  archive("contact_damping", ledger.contact_damping, "J");
  archive("crushing", ledger.crushing, "J");
  archive("local_damping", ledger.local_damping, "J");
  archive("geogrid_damping", ledger.geogrid_damping, "J");
  archive("geogrid_plastic", ledger.geogrid_plastic, "J");
  archive("clamp_work", ledger.clamp_work, "J");
  archive("wall_work", ledger.wall_work, "J");
  archive("inserted", ledger.inserted, "J");
  archive("interface_work_on_stones", ledger.interface_work_on_stones, "J");
  archive("interface_work_on_geogrid", ledger.interface_work_on_geogrid, "J");
  archive("interface_stored_and_lost", ledger.interface_stored_and_lost, "J");
}

// What the stones, the box and their contacts have: the entries of the geogrid are zero.
EnergyLedger ledger_of(const dem::EngineEnergy& stones);

// Entry by entry `end` minus `begin`: the ledger of one stage. Amounts "now" become changes.
EnergyLedger difference(const EnergyLedger& end, const EnergyLedger& begin);
} // namespace interlock::coupling
