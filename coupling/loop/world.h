// Everything of a run that moves: the unit of a checkpoint, of a state hash and of a comparison.
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/loop/rank_times.h"
#include "coupling/loop/rib_transfer.h"
#include "coupling/loop/staggered_step.h"
#include "coupling/loop/step_clock.h"
#include "coupling/parameters/step_rule.h"
#include "dem/engine/engine.h"
#include "dem/parallel/agreement.h"
#include "dem/parallel/domain.h"

#include <memory>
#include <optional>
#include <string>

namespace interlock::coupling
{
// Stones, walls, the geogrid once it is placed, their contacts, the clock. World frame, SI units.
//
// One step is `compute_forces`, a look at the state where somebody wants one, `move`. Between the
// two calls poses and contact forces belong to the same time; energies and records are taken there.
//
// Several ranks may share the stones. In most steps a rank has its part only; where a stage puts
// stones in, takes some out, measures or writes, every rank has everything and does the same, as if
// it were alone (make_whole). `engine` and `ribs` are to be looked at then only, unless a comment
// says otherwise; the functions of this class ask all ranks.
class World
{
public:
  // `gravity` acts along -z [m/s2]; the properties are those of pairs. There is no geogrid yet.
  World(std::vector<dem::ClumpShape> shapes, const dem::ContactProperties& stone_on_stone,
        const dem::ContactProperties& stone_on_rib, double gravity);
  World(const World&) = delete; // the loop below refers to the engine
  World& operator=(const World&) = delete;

  dem::Engine engine;
  StaggeredStep ribs; // contacts of stones with ribs, sub-steps, and what they did
  StepClock clock;
  StepRule step_rule;
  dem::Vector3 clamp_velocity = dem::Vector3::Zero(); // of the geogrid's clamp, next step [m/s]
  double inserted = 0; // energy that no clump brought in when it was added, see ledger() [J]
  bool held = false;   // forces are computed, nothing moves

  // From now on the geogrid takes part. Its energy at this moment is booked as inserted.
  void place_geogrid(std::unique_ptr<RibTransfer> geogrid);
  // The same without booking: for a geogrid whose state is read from a checkpoint next.
  void attach_geogrid(std::unique_ptr<RibTransfer> geogrid);
  RibTransfer* geogrid() { return geogrid_.get(); } // null before it is placed
  const RibTransfer* geogrid() const { return geogrid_.get(); }

  // Several ranks move these stones together from now on, and those near it the geogrid. Nothing
  // changes if there is but one. `ranks` must outlive this object.
  void share_among(const dem::Ranks& ranks);
  bool is_whole() const { return !domain_ || domain_->is_whole(); }
  // The number of ranks that share the stones.
  int n_ranks() const { return domain_ ? domain_->ranks().size() : 1; }
  // The geogrid is where it is now on every rank for which moves_geogrid() is true.
  void complete_geogrid() const { ribs.complete_geogrid(); }
  bool moves_geogrid() const { return ribs.moves_geogrid(); }
  // Everything comes to every rank, until the next step that nobody looks at. Collective, like all
  // below that speak of ranks.
  void make_whole();
  // Before compute_forces: every rank makes the step with everything, or with its part.
  void begin_step(bool whole);

  // What is asked for once a step.
  struct Wishes {
    bool stop = false; // the run
    bool keep = false; // its state
  };
  // What any rank has asked for; with several ranks that of the call before, so that nobody waits.
  // To be called after every move().
  Wishes agree(const Wishes& mine);
  // Over all ranks.
  bool any(bool mine) const { return largest(mine ? 1 : 0) > 0; }
  double largest(double mine) const { return domain_ ? domain_->ranks().largest(mine) : mine; }
  double sum(double mine) const { return domain_ ? domain_->ranks().sum_of(mine) : mine; }
  // Of what each rank counts in its part; where everything is everywhere, that of one.
  double sum_of_parts(double mine) const { return is_whole() ? mine : sum(mine); }
  // What the first rank that says anything says.
  std::string first_sentence(const std::string& mine) const;

  // What ranks did with their time since they share stones, by rank; nothing on one rank.
  std::vector<RankTimes> times() const;

  // For a stage that begins: the time step of step_rule for the present contacts, and as few
  // sub-steps of the ribs as they need.
  void follow_stable_step();
  // Within a stage: lowers the time step where contacts have become stiffer. True if it did.
  bool keep_below_stable_step();

  void compute_forces();
  // Kicks, drifts, sub-steps of the ribs, walls, clock. With several ranks ghosts do not move until
  // agree(): what looks at the step in between, at forces, walls and own stones, hides their way.
  void move();

  // Energies now; call between compute_forces and move. Completes the geogrid: its part is up to
  // date on the first rank and on all that move it.
  EnergyLedger ledger() const;
  // Of all stones, with the velocities half a step back: cheap, for settling criteria [J].
  double kinetic_energy() const { return engine.kinetic_energy(); }
  double weight() const { return engine.gravity() * engine.mass(); } // of all clumps [N]
  // That of the present contacts, ribs included (Engine::stable_step).
  dem::StableStep stable_step() const;
  int touching_spheres() const // contacts between stones
  {
    return static_cast<int>(sum_of_parts(engine.n_touching_spheres()));
  }
  int touching_ribs() const; // contacts of spheres with lines of ribs
  // Largest overlap of any contact of this rank, ribs included, at the last evaluation [m].
  double largest_overlap() const;

  void remove(const std::vector<bool>& clumps) { ribs.remove_clumps(clumps); }

  // Throws std::logic_error when this rank has only a part.
  void require_whole() const;

private:
  void deal();
  void note_times();
  void receive_geogrid();
  RibSide rib_side_of_all() const;
  bool geogrid_has_moved() const;

  std::unique_ptr<RibTransfer> geogrid_;
  // Of several ranks.
  std::optional<dem::Domain> domain_;
  std::optional<dem::Agreement> agreement_;
  bool deal_is_due_ = false;
  int fulfilled_ = 0; // of what ranks ask for once a step: since the last call of agree()
  // Steps after which stones are dealt anew besides, from the environment; for tests. 0: none.
  int deal_every_ = 0;
  dem::VectorField dealt_ribs_; // their ends at the last deal, on the rank that moves them [m]
  RankTimes times_;
  std::int64_t noted_steps_ = 0; // of times_
};

// The field list of a world. Reading goes into a world that has its geogrid, if it has one,
// attached with the lattice of the case.
template <class Archive> void exchange(Archive& archive, World& world)
{
  world.require_whole();
  archive("clock", world.clock);
  archive("step_rule", world.step_rule);
  archive("engine", world.engine);
  archive("inserted", world.inserted, "J");
  archive("clamp_velocity", world.clamp_velocity, "m/s");
  archive("held", world.held);
  if (world.geogrid()) {
    archive("geogrid", *world.geogrid());
    archive("ribs", world.ribs);
  }
}
} // namespace interlock::coupling
