// Everything of a run that moves: the unit of a checkpoint, of a state hash and of a comparison.
#pragma once

#include "coupling/loop/energy_ledger.h"
#include "coupling/loop/rib_transfer.h"
#include "coupling/loop/staggered_step.h"
#include "coupling/loop/step_clock.h"
#include "coupling/parameters/step_rule.h"
#include "dem/engine/engine.h"

#include <memory>

namespace interlock::coupling
{
// Stones, walls, the geogrid once it is placed, their contacts, the clock. World frame, SI units.
//
// One step is `compute_forces`, a look at the state where somebody wants one, `move`. Between the
// two calls poses and contact forces belong to the same time; energies and records are taken there.
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

  // For a stage that begins: the time step of step_rule for the present contacts, and as few
  // sub-steps of the ribs as they need.
  void follow_stable_step();
  // Within a stage: lowers the time step where contacts have become stiffer. True if it did.
  bool keep_below_stable_step();

  void compute_forces() { engine.compute_forces(clock.dt); }
  // Kicks, drifts, sub-steps of the ribs, walls, clock.
  void move();

  // Energies now; call between compute_forces and move.
  EnergyLedger ledger() const;
  // Of all stones, with the velocities half a step back: cheap, for settling criteria [J].
  double kinetic_energy() const { return engine.kinetic_energy(); }
  double weight() const; // of all clumps [N]
  // Largest overlap of any contact, ribs included, at the last evaluation [m].
  double largest_overlap() const;

  void remove(const std::vector<bool>& clumps) { ribs.remove_clumps(clumps); }

private:
  std::unique_ptr<RibTransfer> geogrid_;
};

// The field list of a world. Reading goes into a world that has its geogrid, if it has one,
// attached with the lattice of the case.
template <class Archive> void exchange(Archive& archive, World& world)
{
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
