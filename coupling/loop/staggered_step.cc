#include "coupling/loop/staggered_step.h"

#include <algorithm>

namespace interlock::coupling
{
StaggeredStep::StaggeredStep(dem::Engine& engine, const dem::ContactProperties& stone_on_rib)
    : engine_(engine), rib_contacts_(stone_on_rib)
{
}

void StaggeredStep::place_geogrid(RibTransfer& geogrid)
{
  geogrid_ = &geogrid;
  rib_contacts_.clear();
  const fem::LatticeEnergies e = geogrid.dynamics().energies();
  geogrid_inserted_ = e.kinetic + e.elastic + e.gravitational;
}

void StaggeredStep::remove_clumps(const std::vector<bool>& remove)
{
  // Their springs at ribs go with them.
  geogrid_inserted_ -= rib_contacts_.elastic_energy_of(remove);
  mean_rib_force_.resize(0); // by index
  mean_rib_torque_.resize(0);
  rib_contacts_.renumber_clumps(engine_.remove_clumps(remove));
}

void StaggeredStep::advance(double dt, const dem::Vector3& clamp_velocity, EnergyLedger* ledger)
{
  dem::Clumps& clumps = engine_.clumps();
  engine_.compute_forces(dt);
  if (ledger) book(*ledger, dt);

  near_rib_.resize(0);
  near_rib_.resize(clumps.size());
  mean_rib_force_.resize(clumps.size());
  mean_rib_torque_.resize(clumps.size());
  if (geogrid_) {
    geogrid_->refresh_all_ribs();
    rib_contacts_.update_list(clumps, geogrid_->ribs(), dt);
    for (const int i : rib_contacts_.near_clumps()) near_rib_[i] = 1;
  }
  engine_.kick_all(dt, &mean_rib_force_, &mean_rib_torque_);
  engine_.drift_all(dt, &near_rib_);
  if (geogrid_) {
    // The number of sub-steps only grows, so that velocities stay centred between equal steps.
    substeps_ = std::max(substeps_, geogrid_->required_substeps(dt, rib_contacts_));
    rib_force_.resize(clumps.size());
    rib_torque_.resize(clumps.size());
    clamp_force_.setZero();
    begin_mean_motion();
    for (int s = 0; s < substeps_; ++s) substep(dt / substeps_, clamp_velocity);
    end_mean_motion();
    clamp_force_ /= substeps_;
  }
  engine_.move_walls(dt);
}

void StaggeredStep::substep(double h, const dem::Vector3& clamp_velocity)
{
  dem::Clumps& clumps = engine_.clumps();
  const std::vector<int>& near = rib_contacts_.near_clumps();
  for (const int i : near) {
    rib_force_[i].setZero();
    rib_torque_[i].setZero();
  }
  geogrid_->refresh_ribs(rib_contacts_.near_ribs());
  geogrid_->apply(
      rib_contacts_.evaluate(clumps, geogrid_->ribs(), h, rib_force_, rib_torque_, rib_energy_));

  for (const int i : near) {
    const dem::Vector3 v = clumps.drift_velocity[i], w = clumps.spin[i];
    clumps.kick(i, h, rib_force_[i], rib_torque_[i]);
    clumps.drift(i, h);
    mean_velocity_[i] += clumps.drift_velocity[i];
    mean_spin_[i] += clumps.spin[i];
    mean_rib_force_[i] += rib_force_[i];
    mean_rib_torque_[i] += rib_torque_[i];
    // Work of a kick: force times the mean of the velocities of the drifts before and after it.
    rib_work_on_stones_ +=
        0.5 * h *
        (rib_force_[i].dot(v + clumps.drift_velocity[i]) + rib_torque_[i].dot(w + clumps.spin[i]));
  }
  geogrid_->dynamics().set_clamp_velocity(clamp_velocity);
  geogrid_->dynamics().step(h);
  clamp_force_ += geogrid_->dynamics().clamp_reaction();
}

// The contacts between stones must see the mean motion of the whole step: the velocity of the last
// sub-step alone swings with the kicks of the rib and would make their tangential springs creep.
void StaggeredStep::begin_mean_motion()
{
  mean_velocity_.resize(engine_.clumps().size());
  mean_spin_.resize(engine_.clumps().size());
  for (dem::VectorField* mean : {&mean_rib_force_, &mean_rib_torque_}) {
    mean->resize(0);
    mean->resize(engine_.clumps().size());
  }
  for (const int i : rib_contacts_.near_clumps()) {
    mean_velocity_[i].setZero();
    mean_spin_[i].setZero();
  }
}

void StaggeredStep::end_mean_motion()
{
  for (const int i : rib_contacts_.near_clumps()) {
    engine_.clumps().step_velocity[i] = mean_velocity_[i] / substeps_;
    engine_.clumps().step_spin[i] = mean_spin_[i] / substeps_;
    mean_rib_force_[i] /= substeps_;
    mean_rib_torque_[i] /= substeps_;
  }
}

void StaggeredStep::book(EnergyLedger& ledger, double dt) const
{
  ledger = ledger_of(engine_.energy(dt));
  if (!geogrid_) return;

  ledger.elastic_contacts += rib_energy_.elastic;
  ledger.friction += rib_energy_.friction;
  ledger.contact_damping += rib_energy_.damping;
  ledger.interface_work_on_stones = rib_work_on_stones_;
  ledger.interface_stored_and_lost =
      rib_energy_.elastic + rib_energy_.friction + rib_energy_.damping;
  const fem::LatticeEnergies lattice = geogrid_->dynamics().energies();
  ledger.kinetic_geogrid = lattice.kinetic;
  ledger.gravitational += lattice.gravitational;
  ledger.elastic_geogrid = lattice.elastic;
  ledger.geogrid_damping = lattice.damping_loss;
  ledger.clamp_work = lattice.clamp_work;
  ledger.interface_work_on_geogrid = lattice.load_work;
  ledger.inserted += geogrid_inserted_;
}
} // namespace interlock::coupling
