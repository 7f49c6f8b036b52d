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
#include "dem/bodies/subcycled_clumps.h"
#include "dem/engine/engine.h"
#include "dem/parallel/domain.h"

namespace interlock::coupling
{
class StaggeredStep
{
public:
  // Both must outlive this object. `stone_on_rib`: pair properties of the contacts with ribs.
  StaggeredStep(dem::Engine& engine, const dem::ContactProperties& stone_on_rib);

  // From now on the geogrid takes part; its energy at this moment is booked as inserted.
  void place_geogrid(RibTransfer& geogrid);
  // The same without booking: for a geogrid whose state, and whose contacts, are read next.
  void attach(RibTransfer& geogrid);
  // From now on ranks share the stones, and the first of them moves the geogrid and the stones near
  // it; `domain` must outlive this object.
  void share(dem::Domain& domain) { domain_ = &domain; }
  // Whether a stone that another rank moves has come near: it should be dealt to this one soon.
  bool stranger_is_near() const { return stranger_is_near_; }
  // What contacts with ribs remember, and going on from it: around an exchange of the engine's
  // clumps among ranks.
  std::vector<dem::RibMemory> contact_memory() const
  {
    return rib_contacts_.memory(engine_.clumps());
  }
  void restore_contacts(const std::vector<dem::RibMemory>& contacts)
  {
    rib_contacts_.restore(engine_.clumps(), contacts);
  }

  // Advances everything by dt [s]. `clamp_velocity` holds for the whole step [m/s]. With `ledger`,
  // fills it for the beginning of this step.
  void advance(double dt, const dem::Vector3& clamp_velocity, EnergyLedger* ledger = nullptr);
  // The part of a step after the engine has computed its forces.
  void move(double dt, const dem::Vector3& clamp_velocity);
  // Energies now; call between the engine's compute_forces and move.
  EnergyLedger ledger(double dt) const;

  // Removes clumps from the engine and from the contacts with ribs.
  void remove_clumps(const std::vector<bool>& remove);

  // Mean force of the clamp on the lattice over the last step [N].
  const dem::Vector3& clamp_force() const { return clamp_force_; }
  int substeps() const { return substeps_; }
  // Wall-clock time since the begin: of the geogrid with what is near it, and of copying ghosts,
  // waiting for other ranks included [s].
  double geogrid_time() const { return geogrid_time_; }
  double copy_time() const { return copy_time_; }
  // The next step takes as many sub-steps as it needs, also if that is fewer than before.
  void forget_substeps() { substeps_ = 1; }
  const dem::RibContacts& rib_contacts() const { return rib_contacts_; }
  // Pair properties of stones with ribs; changing them between steps is allowed.
  dem::ContactProperties& stone_on_rib() { return rib_contacts_.properties(); }
  const RibTransfer* geogrid() const { return geogrid_; }

  // Of a loop with its geogrid attached.
  template <class Archive> friend void exchange(Archive& archive, StaggeredStep& loop)
  {
    archive("energy", loop.rib_energy_);
    archive("inserted", loop.geogrid_inserted_, "J");
    archive("removed", loop.rib_energy_removed_, "J");
    archive("work_on_stones", loop.rib_work_on_stones_, "J");
    archive("substeps", loop.substeps_);
    archive("clamp_force", loop.clamp_force_, "N");
    archive("mean_loads", loop.mean_loads_);
    std::vector<dem::RibMemory> contacts;
    if (!Archive::reading) contacts = loop.rib_contacts_.memory(loop.engine_.clumps());
    archive("contacts", contacts);
    if (Archive::reading) loop.rib_contacts_.restore(loop.engine_.clumps(), contacts);
  }

private:
  // What ribs did to one stone near them, mean over the last step: local damping takes it for that
  // of the step to come.
  struct MeanLoad {
    std::int64_t clump = 0;                                                   // id
    dem::Vector3 force = dem::Vector3::Zero(), torque = dem::Vector3::Zero(); // [N], [N m]
    template <class Archive> friend void exchange(Archive& archive, MeanLoad& load)
    {
      archive("clump", load.clump);
      archive("force", load.force, "N");
      archive("torque", load.torque, "N m");
    }
  };
  bool is_dealt() const { return domain_ && !domain_->is_whole(); }
  bool moves_geogrid() const // on this rank
  {
    return geogrid_ && !(is_dealt() && domain_->ranks().rank() > 0);
  }
  void kick_by_stones_and_walls(double dt);
  void move_with_geogrid(double dt, const dem::Vector3& clamp_velocity);
  void look_for_strangers();
  void hold_near_clumps();
  void substep(double h, const dem::Vector3& clamp_velocity);
  void end_substeps();

  dem::Engine& engine_;
  dem::Domain* domain_ = nullptr; // null: one rank
  RibTransfer* geogrid_ = nullptr;
  dem::RibContacts rib_contacts_;
  dem::ContactEnergy rib_energy_;
  double geogrid_inserted_ = 0;   // energy of the lattice when it was placed [J]
  double rib_energy_removed_ = 0; // of contacts with ribs, gone with their stones [J]
  double rib_work_on_stones_ = 0; // [J]
  int seen_builds_ = 0;           // of the list of rib_contacts_
  bool stranger_is_near_ = false;
  dem::SubcycledClumps near_;                   // the near clumps of rib_contacts_, in a step
  std::vector<MeanLoad> mean_loads_;            // of the last step, ascending ids
  dem::VectorField other_force_, other_torque_; // mean_loads_ by clump
  dem::ScalarField held_;                       // 1: drifts in sub-steps
  // Only grows within a stage, so that velocities stay centred between equal steps: part of the
  // state.
  int substeps_ = 1;
  double geogrid_time_ = 0, copy_time_ = 0; // [s]
  dem::Vector3 clamp_force_ = dem::Vector3::Zero();
};
} // namespace interlock::coupling
