// One step of the coupled loop: stones at the step of the DEM, beams and the stones near them in
// sub-steps.
//
// The scheme is an impulse (r-RESPA) split of the leapfrog: forces between stones and with walls
// are kicked in once a step; the contacts with ribs, which are stiff against the light ribs, are
// evaluated at every sub-step, where they kick the stones and load the lattice together. A contact
// force frozen over several sub-steps would be unstable, and a stone kicked by ribs only at the end
// of the step would gain energy (docs/theory/coupling.md).
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/loop/rib_transfer.h"
#include "dem/engine/engine.h"

namespace interlock::coupling
{
class StaggeredStep
{
public:
  // Both must outlive this object. `stone_on_rib`: pair properties of the contacts with ribs.
  StaggeredStep(dem::Engine& engine, const dem::ContactProperties& stone_on_rib);

  // From now on the geogrid takes part; its energy at this moment is booked as inserted.
  void place_geogrid(RibTransfer& geogrid);

  // Advances everything by dt [s]. `clamp_velocity` holds for the whole step [m/s]. With `ledger`,
  // fills it for the beginning of this step.
  void advance(double dt, const dem::Vector3& clamp_velocity, EnergyLedger* ledger = nullptr);

  // Removes clumps from the engine and from the contacts with ribs.
  void remove_clumps(const std::vector<bool>& remove);

  // Mean force of the clamp on the lattice over the last step [N].
  const dem::Vector3& clamp_force() const { return clamp_force_; }
  int substeps() const { return substeps_; }
  const dem::RibContacts& rib_contacts() const { return rib_contacts_; }
  const RibTransfer* geogrid() const { return geogrid_; }

private:
  void substep(double h, const dem::Vector3& clamp_velocity);
  void begin_mean_motion();
  void end_mean_motion();
  void book(EnergyLedger& ledger, double dt) const;

  dem::Engine& engine_;
  RibTransfer* geogrid_ = nullptr;
  dem::RibContacts rib_contacts_;
  dem::ContactEnergy rib_energy_;
  double geogrid_inserted_ = 0;                // energy of the lattice when it was placed [J]
  double rib_work_on_stones_ = 0;              // [J]
  dem::VectorField rib_force_, rib_torque_;    // on clumps, of the present sub-step
  dem::VectorField mean_velocity_, mean_spin_; // sums over the sub-steps so far
  // Forces and torques of ribs on clumps, means over the last step: local damping takes them for
  // those of the step to come [N], [N m].
  dem::VectorField mean_rib_force_, mean_rib_torque_;
  dem::ScalarField near_rib_; // 1: drifts in sub-steps
  int substeps_ = 1;
  dem::Vector3 clamp_force_ = dem::Vector3::Zero();
};
} // namespace interlock::coupling
