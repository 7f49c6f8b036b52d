#include "coupling/loop/staggered_step.h"

#include "coupling/loop/stopwatch.h"

#include <algorithm>
#include <utility>

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
  rib_energy_removed_ += rib_contacts_.elastic_energy_of(remove);
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
  if (geogrid_ && moves_geogrid())
    move_with_geogrid(dt, clamp_velocity);
  else
    engine_.drift_all(dt, is_dealt() ? &engine_.clumps().ghost : nullptr);
  if (is_dealt()) {
    const Stopwatch watch(copy_time_);
    domain_->start_refresh(engine_);
    ghosts_come_ = true;
  }
  engine_.move_walls(dt);
}

void StaggeredStep::receive_ghosts()
{
  if (!ghosts_come_) return;
  const Stopwatch watch(copy_time_);
  domain_->finish_refresh(engine_);
  ghosts_come_ = false;
}

void StaggeredStep::move_with_geogrid(double dt, const dem::Vector3& clamp_velocity)
{
  const Stopwatch watch(is_dealt() ? &geogrid_time_ : nullptr);
  geogrid_->refresh_ribs();
  rib_contacts_.update_list(engine_.clumps(), geogrid_->ribs(), dt);
  geogrid_->update_walls(dt);
  hold_near_clumps();
  engine_.drift_all(dt, &held_);

  const int required = required_substeps(dt);
  // A rigid geogrid needs one, also where a flexible one has been made rigid.
  substeps_ = geogrid_->rigid() ? required : std::max(substeps_, required);
  clamp_force_.setZero();
  for (int s = 0; s < substeps_; ++s) substep(dt / substeps_, clamp_velocity);
  end_substeps();
  if (is_dealt()) {
    const Stopwatch waiting(told_time_);
    clamp_force_ = geogrid_ranks_->sum_of_parts(clamp_force_);
  }
  clamp_force_ /= substeps_;
}

// The same on all ranks that move the geogrid.
int StaggeredStep::required_substeps(double dt)
{
  if (geogrid_->rigid()) return 1;
  std::vector<NodeRate> rates = geogrid_->contact_rates(rib_contacts_);
  if (is_dealt()) {
    const Stopwatch watch(told_time_);
    rates = geogrid_ranks_->all_rates(rates);
  }
  geogrid_->add_wall_rates(rates);
  // Ribs bend slowly, and what they once asked for stays.
  constexpr int steps_between_looks = 16;
  const bool looks_at_bends = steps_to_look_ == 0;
  steps_to_look_ = looks_at_bends ? steps_between_looks - 1 : steps_to_look_ - 1;
  SubstepNeeds needs = geogrid_->substep_needs(rates, looks_at_bends);
  if (is_dealt()) {
    const Stopwatch watch(told_time_);
    needs = geogrid_ranks_->largest_of_parts(needs);
  }
  return geogrid_->required_substeps(dt, needs, rib_contacts_.properties().damping_ratio);
}

// Local damping goes by the whole unbalanced force, that of the ribs included.
void StaggeredStep::kick_by_stones_and_walls(double dt)
{
  if (mean_loads_.empty() || engine_.local_damping() == 0) {
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

// The stones that may touch a rib within the step drift in its sub-steps, with the ribs, and ghosts
// not at all.
void StaggeredStep::hold_near_clumps()
{
  held_ = engine_.clumps().ghost;
  for (const int i : rib_contacts_.near_clumps()) held_[i] = 1;
  near_.take(engine_.clumps(), rib_contacts_.near_clumps());
}

void StaggeredStep::substep(double h, const dem::Vector3& clamp_velocity)
{
  double* lattice_time = is_dealt() ? &lattice_time_ : nullptr;
  near_.clear_loads();
  {
    const Stopwatch watch(lattice_time);
    geogrid_->refresh_ribs();
  }
  dem::ContactEnergy energy;
  load_lattice(rib_contacts_.evaluate(near_, geogrid_->ribs(), h, energy));
  rib_friction_.add(energy.friction);
  rib_damping_.add(energy.damping);
  rib_crushing_.add(energy.crushing);
  rib_work_on_stones_.add(near_.move(h));
  {
    const Stopwatch watch(lattice_time);
    geogrid_->apply_walls(h);
    geogrid_->dynamics().set_clamp_velocity(clamp_velocity);
    geogrid_->dynamics().step(h);
    clamp_force_ += geogrid_->clamp_force();
  }
  if (!is_dealt()) return;
  const Stopwatch watch(told_time_);
  geogrid_ranks_->refresh();
}

void StaggeredStep::load_lattice(const std::vector<dem::RodLoads>& mine)
{
  if (!is_dealt()) {
    geogrid_->apply(mine);
    return;
  }
  const Stopwatch watch(told_time_);
  geogrid_->apply(geogrid_ranks_->all_loads(mine, rib_contacts_, engine_.clumps()));
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

RibSide StaggeredStep::memory() const
{
  return {rib_contacts_.memory(engine_.clumps()), mean_loads_};
}

void StaggeredStep::restore(RibSide side)
{
  const dem::Clumps& clumps = engine_.clumps();
  side.keep([&](std::int64_t id) {
    const int i = clumps.index_of(id);
    return i >= 0 && clumps.ghost[i] == 0;
  });
  rib_contacts_.restore(clumps, side.contacts);
  mean_loads_ = std::move(side.mean_loads);
}

void StaggeredStep::choose_geogrid_ranks()
{
  geogrid_ranks_.emplace(*domain_, engine_.clumps(), *geogrid_);
}

void StaggeredStep::complete_geogrid() const
{
  if (geogrid_ && is_dealt()) geogrid_ranks_->gather();
}

void StaggeredStep::unite_sums()
{
  for (EnergySum* sum : {&rib_friction_, &rib_damping_, &rib_crushing_, &rib_work_on_stones_})
    sum->unite([this](double mine) { return sum_of_parts(mine); });
}

std::vector<double> StaggeredStep::loads_on_lines() const
{
  std::vector<std::vector<double>> forces(geogrid_->lattice().n_lines());
  for (const dem::RibContact& c : rib_contacts_.contacts()) forces[c.line].push_back(-c.force.x());
  std::vector<double> loads;
  for (const std::vector<double>& of_line : forces)
    loads.push_back(dem::order_free_sum(of_line, over_ranks()));
  return loads;
}

dem::OverRanks StaggeredStep::over_ranks() const
{
  if (!is_dealt()) return {};
  const dem::Ranks& ranks = domain_->ranks();
  return {[&ranks](std::vector<double>& numbers) { ranks.sum(numbers); },
          [&ranks](double mine) { return ranks.largest(mine); }};
}

double StaggeredStep::sum_of_parts(double mine) const
{
  return is_dealt() ? domain_->ranks().sum_of(mine) : mine;
}

double StaggeredStep::total(const EnergySum& sum) const
{
  return sum.value([this](double mine) { return sum_of_parts(mine); });
}

EnergyLedger StaggeredStep::ledger(double dt) const
{
  EnergyLedger ledger = ledger_of(engine_.energy(dt));
  if (!geogrid_) return ledger;

  complete_geogrid();
  const RibWalls* walls = geogrid_->walls();
  const dem::ContactEnergy at_walls = walls ? walls->energy() : dem::ContactEnergy();
  const double elastic =
      dem::order_free_sum(rib_contacts_.elastic_energies(), over_ranks()) + at_walls.elastic;
  const double friction = total(rib_friction_) + at_walls.friction,
               damping = total(rib_damping_) + at_walls.damping, crushing = total(rib_crushing_);
  ledger.elastic_contacts += elastic;
  ledger.friction += friction;
  ledger.contact_damping += damping;
  ledger.crushing += crushing;
  ledger.interface_work_on_stones = total(rib_work_on_stones_);
  ledger.interface_stored_and_lost = elastic + friction + damping + crushing + rib_energy_removed_;
  const fem::LatticeEnergies lattice = geogrid_->dynamics().energies();
  ledger.kinetic_geogrid = lattice.kinetic;
  ledger.gravitational += lattice.gravitational;
  ledger.elastic_geogrid = lattice.elastic;
  ledger.geogrid_damping = lattice.damping_loss;
  ledger.geogrid_plastic = lattice.plastic_loss;
  ledger.clamp_work = lattice.clamp_work;
  ledger.interface_work_on_geogrid = lattice.load_work;
  ledger.inserted += geogrid_inserted_ - rib_energy_removed_;
  return ledger;
}
} // namespace interlock::coupling
