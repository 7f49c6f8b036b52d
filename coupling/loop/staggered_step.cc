#include "coupling/loop/staggered_step.h"

#include "coupling/loop/stopwatch.h"

#include <algorithm>
#include <stdexcept>

namespace interlock::coupling
{
StaggeredStep::StaggeredStep(dem::Engine& engine, const dem::ContactProperties& stone_on_rib)
    : engine_(engine), rib_contacts_(stone_on_rib)
{
}

void StaggeredStep::place_geogrid(RibTransfer& geogrid)
{
  attach(geogrid);
  const fem::LatticeEnergies e = geogrid.dynamics().energies();
  geogrid_inserted_ = e.kinetic + e.elastic + e.gravitational;
}

void StaggeredStep::attach(RibTransfer& geogrid)
{
  geogrid_ = &geogrid;
  rib_contacts_.clear();
}

void StaggeredStep::remove_clumps(const std::vector<bool>& remove)
{
  // Their springs at ribs go with them, from this moment on.
  const double gone = rib_contacts_.elastic_energy_of(remove);
  rib_energy_.elastic -= gone;
  rib_energy_removed_ += gone;
  rib_contacts_.renumber_clumps(engine_.remove_clumps(remove));
}

void StaggeredStep::advance(double dt, const dem::Vector3& clamp_velocity, EnergyLedger* ledger)
{
  engine_.compute_forces(dt);
  if (ledger) *ledger = this->ledger(dt);
  move(dt, clamp_velocity);
}

void StaggeredStep::move(double dt, const dem::Vector3& clamp_velocity)
{
  kick_by_stones_and_walls(dt);
  if (moves_geogrid()) {
    const Stopwatch watch(geogrid_time_);
    move_with_geogrid(dt, clamp_velocity);
  } else
    engine_.drift_all(dt, is_dealt() ? &engine_.clumps().ghost : nullptr);
  if (is_dealt()) {
    const Stopwatch watch(copy_time_);
    domain_->refresh(engine_);
  }
  engine_.move_walls(dt);
}

void StaggeredStep::move_with_geogrid(double dt, const dem::Vector3& clamp_velocity)
{
  geogrid_->refresh_ribs();
  rib_contacts_.update_list(engine_.clumps(), geogrid_->ribs(), dt);
  look_for_strangers();
  hold_near_clumps();
  engine_.drift_all(dt, &held_);

  const int required = geogrid_->required_substeps(dt, rib_contacts_);
  // A rigid geogrid needs one, also where a flexible one has been made rigid.
  substeps_ = geogrid_->rigid() ? required : std::max(substeps_, required);
  clamp_force_.setZero();
  for (int s = 0; s < substeps_; ++s) substep(dt / substeps_, clamp_velocity);
  end_substeps();
  clamp_force_ /= substeps_;
}

// Local damping goes by the whole unbalanced force, that of the ribs included.
void StaggeredStep::kick_by_stones_and_walls(double dt)
{
  if (mean_loads_.empty() || engine_.local_damping() == 0 || !moves_geogrid()) {
    engine_.kick_all(dt);
    return;
  }
  const dem::Clumps& clumps = engine_.clumps();
  for (dem::VectorField* field : {&other_force_, &other_torque_}) {
    field->resize(0);
    field->resize(clumps.size());
  }
  for (const MeanLoad& load : mean_loads_) {
    const int i = clumps.index_of(load.clump);
    if (i < 0) continue; // taken out since
    other_force_[i] = load.force;
    other_torque_[i] = load.torque;
  }
  engine_.kick_all(dt, &other_force_, &other_torque_);
}

// Any that is in the list has some way to go before it is near.
void StaggeredStep::look_for_strangers()
{
  if (!is_dealt() || rib_contacts_.builds() == seen_builds_) return;
  seen_builds_ = rib_contacts_.builds();
  const auto& contacts = rib_contacts_.contacts();
  stranger_is_near_ = std::any_of(contacts.begin(), contacts.end(), [&](const dem::RibContact& c) {
    return engine_.clumps().ghost[c.i] == 1;
  });
}

// The stones that may touch a rib within the step drift in its sub-steps, with the ribs, and ghosts
// not at all.
void StaggeredStep::hold_near_clumps()
{
  held_ = engine_.clumps().ghost;
  for (const int i : rib_contacts_.near_clumps()) {
    if (held_[i] == 1) throw std::logic_error("Another rank moves a stone near the geogrid.");
    held_[i] = 1;
  }
  near_.take(engine_.clumps(), rib_contacts_.near_clumps());
}

void StaggeredStep::substep(double h, const dem::Vector3& clamp_velocity)
{
  near_.clear_loads();
  geogrid_->refresh_ribs();
  geogrid_->apply(rib_contacts_.evaluate(near_, geogrid_->ribs(), h, rib_energy_));
  rib_work_on_stones_ += near_.move(h);
  geogrid_->dynamics().set_clamp_velocity(clamp_velocity);
  geogrid_->dynamics().step(h);
  clamp_force_ += geogrid_->dynamics().clamp_reaction();
}

// The contacts between stones must see the mean motion of the whole step, as put_back() gives it:
// the velocity of the last sub-step alone swings with the kicks of the rib and would make their
// tangential springs creep.
void StaggeredStep::end_substeps()
{
  near_.put_back(engine_.clumps());
  mean_loads_.clear();
  for (int place = 0; place < near_.size(); ++place)
    mean_loads_.push_back({engine_.clumps().id[rib_contacts_.near_clumps()[place]],
                           near_.mean_force(place), near_.mean_torque(place)});
}

EnergyLedger StaggeredStep::ledger(double dt) const
{
  EnergyLedger ledger = ledger_of(engine_.energy(dt));
  if (!geogrid_) return ledger;

  ledger.elastic_contacts += rib_energy_.elastic;
  ledger.friction += rib_energy_.friction;
  ledger.contact_damping += rib_energy_.damping;
  ledger.interface_work_on_stones = rib_work_on_stones_;
  ledger.interface_stored_and_lost =
      rib_energy_.elastic + rib_energy_.friction + rib_energy_.damping + rib_energy_removed_;
  const fem::LatticeEnergies lattice = geogrid_->dynamics().energies();
  ledger.kinetic_geogrid = lattice.kinetic;
  ledger.gravitational += lattice.gravitational;
  ledger.elastic_geogrid = lattice.elastic;
  ledger.geogrid_damping = lattice.damping_loss;
  ledger.clamp_work = lattice.clamp_work;
  ledger.interface_work_on_geogrid = lattice.load_work;
  ledger.inserted += geogrid_inserted_ - rib_energy_removed_;
  return ledger;
}
} // namespace interlock::coupling
