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
#include "coupling/loop/geogrid_ranks.h"
#include "coupling/loop/rib_side.h"
#include "coupling/loop/rib_transfer.h"
#include "dem/bodies/subcycled_clumps.h"
#include "dem/engine/engine.h"
#include "dem/exact_sums.h"
#include "dem/parallel/domain.h"

#include <optional>

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
  // From now on ranks share the stones; `domain` must outlive this object.
  void share(dem::Domain& domain) { domain_ = &domain; }
  // What the stones of this rank remember of ribs, and going on from it: around an exchange of the
  // engine's clumps among ranks. What is remembered of stones that this rank does not move is not
  // taken.
  RibSide memory() const;
  void restore(RibSide side);
  // After stones have been dealt: which ranks move the geogrid. Before they are dealt or gathered:
  // what ranks have added to sums since. Collective among all of them.
  void choose_geogrid_ranks();
  void unite_sums();
  // The whole geogrid where it is now, on all ranks that move it: of a large one each rank moves a
  // part. Collective among all ranks.
  void complete_geogrid() const;
  // Whether this rank moves, and all ranks move, the geogrid or a part of it.
  bool moves_geogrid() const { return !is_dealt() || geogrid_ranks_->moves_here(); }
  bool all_move_geogrid() const { return !is_dealt() || geogrid_ranks_->moves_everywhere(); }
  // What a rank that did not move the geogrid takes over from one that did.
  template <class Archive> void exchange_step(Archive& archive)
  {
    archive("substeps", substeps_);
    archive("steps_to_look", steps_to_look_);
    archive("clamp_force", clamp_force_, "N");
  }

  // Advances everything by dt [s]. `clamp_velocity` holds for the whole step [m/s]. With `ledger`,
  // fills it for the beginning of this step.
  void advance(double dt, const dem::Vector3& clamp_velocity, EnergyLedger* ledger = nullptr);
  // The part of a step after the engine has computed its forces.
  // Several ranks: ghosts are on their way afterwards, and where they were before until
  // receive_ghosts(); what nobody needs them for goes on meanwhile.
  void move(double dt, const dem::Vector3& clamp_velocity);
  void receive_ghosts();
  // Energies now; call between the engine's compute_forces and move. Collective among all ranks.
  EnergyLedger ledger(double dt) const;

  // Force along x that stones exert on each line of ribs, at the last evaluation of the contacts
  // [N]. Collective among all ranks.
  std::vector<double> loads_on_lines() const;

  // Removes clumps from the engine and from the contacts with ribs.
  void remove_clumps(const std::vector<bool>& remove);

  // Mean force of the clamp on the lattice over the last step [N].
  const dem::Vector3& clamp_force() const { return clamp_force_; }
  int substeps() const { return substeps_; }
  // Wall-clock time since the begin of the steps that ranks share: of the lattice, of stones at
  // ribs, and of messages, waiting for other ranks included [s].
  double lattice_time() const { return lattice_time_; }
  double rib_time() const { return geogrid_time_ - lattice_time_ - told_time_; }
  double message_time() const { return copy_time_ + told_time_; }
  // The next step takes as many sub-steps as it needs, also if that is fewer than before.
  void forget_substeps() { substeps_ = 1, steps_to_look_ = 0; }
  const dem::RibContacts& rib_contacts() const { return rib_contacts_; }
  // Pair properties of stones with ribs; changing them between steps is allowed.
  dem::ContactProperties& stone_on_rib() { return rib_contacts_.properties(); }
  const RibTransfer* geogrid() const { return geogrid_; }

  // Of a loop with its geogrid attached, when this rank has everything.
  template <class Archive> friend void exchange(Archive& archive, StaggeredStep& loop)
  {
    if (!Archive::reading) loop.unite_sums();
    archive("friction", loop.rib_friction_);
    archive("damping", loop.rib_damping_);
    archive("crushing", loop.rib_crushing_);
    archive("inserted", loop.geogrid_inserted_, "J");
    archive("removed", loop.rib_energy_removed_, "J");
    archive("work_on_stones", loop.rib_work_on_stones_);
    loop.exchange_step(archive);
    RibSide side;
    if (!Archive::reading) side = loop.memory();
    exchange(archive, side);
    if (Archive::reading) loop.restore(std::move(side));
  }

private:
  using EnergySum = dem::SharedSum<dem::energy_grid>;

  bool is_dealt() const { return domain_ && !domain_->is_whole(); }
  dem::OverRanks over_ranks() const;
  double sum_of_parts(double mine) const;
  double total(const EnergySum& sum) const; // over all ranks [J]
  void kick_by_stones_and_walls(double dt);
  void move_with_geogrid(double dt, const dem::Vector3& clamp_velocity);
  void hold_near_clumps();
  int required_substeps(double dt);
  void substep(double h, const dem::Vector3& clamp_velocity);
  void load_lattice(const std::vector<dem::RodLoads>& mine);
  void end_substeps();

  dem::Engine& engine_;
  dem::Domain* domain_ = nullptr; // null: one rank
  RibTransfer* geogrid_ = nullptr;
  dem::RibContacts rib_contacts_;
  std::optional<GeogridRanks> geogrid_ranks_; // since the last deal
  // What contacts with ribs have taken, and done to stones, since the start [J].
  EnergySum rib_friction_, rib_damping_, rib_crushing_, rib_work_on_stones_;
  double geogrid_inserted_ = 0;                 // energy of the lattice when it was placed [J]
  double rib_energy_removed_ = 0;               // of contacts with ribs, gone with their stones [J]
  dem::SubcycledClumps near_;                   // the near clumps of rib_contacts_, in a step
  std::vector<MeanLoad> mean_loads_;            // of the last step, ascending ids
  dem::VectorField other_force_, other_torque_; // mean_loads_ by clump
  dem::ScalarField held_;                       // 1: drifts in sub-steps
  // Only grows within a stage, so that velocities stay centred between equal steps: part of the
  // state.
  int substeps_ = 1;
  int steps_to_look_ = 0; // until the bends of the ribs are looked at
  bool ghosts_come_ = false;
  double geogrid_time_ = 0, lattice_time_ = 0, told_time_ = 0, copy_time_ = 0; // [s]
  dem::Vector3 clamp_force_ = dem::Vector3::Zero();
};
} // namespace interlock::coupling
