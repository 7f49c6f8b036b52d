#include "coupling/loop/energy_ledger.h"

#include "dem/engine/engine.h"

#include <cmath>

namespace interlock::coupling
{
namespace
{
// One table for everything that walks over the entries.
struct NamedEntry {
  const char* name;
  double EnergyLedger::*member;
};
const NamedEntry table[] = {
    {"kinetic_stones", &EnergyLedger::kinetic_stones},
    {"kinetic_geogrid", &EnergyLedger::kinetic_geogrid},
    {"gravitational", &EnergyLedger::gravitational},
    {"elastic_contacts", &EnergyLedger::elastic_contacts},
    {"elastic_geogrid", &EnergyLedger::elastic_geogrid},
    {"friction", &EnergyLedger::friction},
    {"contact_damping", &EnergyLedger::contact_damping},
    {"crushing", &EnergyLedger::crushing},
    {"local_damping", &EnergyLedger::local_damping},
    {"geogrid_damping", &EnergyLedger::geogrid_damping},
    {"geogrid_plastic", &EnergyLedger::geogrid_plastic},
    {"clamp_work", &EnergyLedger::clamp_work},
    {"wall_work", &EnergyLedger::wall_work},
    {"inserted", &EnergyLedger::inserted},
    {"interface_work_on_stones", &EnergyLedger::interface_work_on_stones},
    {"interface_work_on_geogrid", &EnergyLedger::interface_work_on_geogrid},
    {"interface_stored_and_lost", &EnergyLedger::interface_stored_and_lost},
};
} // namespace

double EnergyLedger::residual() const
{
  const double stored =
      kinetic_stones + kinetic_geogrid + gravitational + elastic_contacts + elastic_geogrid;
  const double dissipated =
      friction + contact_damping + crushing + local_damping + geogrid_damping + geogrid_plastic;
  return stored + dissipated - clamp_work - wall_work - inserted;
}

double EnergyLedger::work_put_in() const
{
  return std::abs(clamp_work) + std::abs(wall_work) + std::abs(inserted - gravitational);
}

double EnergyLedger::relative_error() const
{
  const double work = work_put_in();
  return work > 0 ? std::abs(residual()) / work : 0;
}

std::vector<std::pair<std::string, double>> EnergyLedger::entries() const
{
  std::vector<std::pair<std::string, double>> result;
  for (const NamedEntry& entry : table) result.emplace_back(entry.name, this->*entry.member);
  return result;
}

EnergyLedger ledger_of(const dem::EngineEnergy& stones)
{
  EnergyLedger ledger;
  ledger.kinetic_stones = stones.kinetic;
  ledger.gravitational = stones.gravitational;
  ledger.elastic_contacts = stones.contact.elastic;
  ledger.friction = stones.contact.friction;
  ledger.contact_damping = stones.contact.damping;
  ledger.crushing = stones.contact.crushing;
  ledger.local_damping = stones.local_damping;
  ledger.wall_work = stones.wall_work;
  ledger.inserted = stones.inserted;
  return ledger;
}

EnergyLedger difference(const EnergyLedger& end, const EnergyLedger& begin)
{
  EnergyLedger result;
  for (const NamedEntry& entry : table)
    result.*entry.member = end.*entry.member - begin.*entry.member;
  return result;
}
} // namespace interlock::coupling
