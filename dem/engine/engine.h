// The DEM engine: clumps, walls and their contacts, advanced by leapfrog.
//
// The caller owns the loop. One step without ribs reads
//     engine.compute_forces(dt);   // contacts at the present poses
//     engine.kick_all(dt);
//     engine.drift_all(dt);
//     engine.move_walls(dt);
// and with ribs the kick of the outer forces stays, while clumps near ribs drift in sub-steps
// (coupling/loop/staggered_step.h). How it works: docs/theory/engine.md.
#pragma once

#include "dem/contacts/contact_memory.h"
#include "dem/contacts/contact_views.h"
#include "dem/engine/local_damping.h"
#include "dem/engine/rolling_resistance.h"
#include "dem/exact_sums.h"
#include "dem/lists/neighbour_lists.h"
#include "dem/ribs/rib_contacts.h"
#include "dem/walls/force_control.h"
#include "dem/walls/mesh_contacts.h"

#include <optional>

namespace interlock::dem
{
// Energies of the clumps and of their contacts with each other and with walls [J].
struct EngineEnergy {
  double kinetic = 0;       // at the present whole step
  double gravitational = 0; // m g z, zero at z = 0
  ContactEnergy contact;    // elastic: now; the others: since the beginning
  double local_damping = 0; // dissipated by local damping, since the beginning
  double wall_work = 0;     // done by moving walls on clumps, since the beginning
  double inserted = 0; // kinetic + gravitational energy of clumps when they were added, and, with
                       // negative sign, everything that went when clumps were removed
};

// The step at which the explicit integration would become unstable for the present contacts, and
// the clump that limits it; before there are contacts, the shape that would limit it.
struct StableStep {
  double step = 0;            // [s]
  std::int64_t clump_id = -1; // -1: before there are contacts
  int shape = -1;             // of that clump, an index into Clumps::shapes()
  double mass = 0;            // of that clump [kg]
  int contacts = 0;           // of that clump
  double stiffness = 0;       // mean of its contacts [N/m]
  double rotation_share = 0;  // of its mobility at the contacts, the rest is translation [-]
};

template <class Archive> void exchange(Archive& archive, StableStep& s)
{
  archive("step", s.step, "s");
  archive("clump", s.clump_id);
  archive("shape", s.shape);
  archive("mass", s.mass, "kg");
  archive("contacts", s.contacts);
  archive("stiffness", s.stiffness, "N/m");
  archive("rotation_share", s.rotation_share);
}

// Time spent in the parts of the steps since the last reset [s].
struct StepProfile {
  double broad_phase = 0; // clump pairs
  double lists = 0;       // sphere pairs
  double contacts = 0;    // laws and sums
  double integration = 0;
  ListCounts counts; // since the beginning
};

class Engine
{
public:
  // `gravity` acts along -z [m/s2]; `stone_on_stone` holds the pair properties of stones.
  Engine(std::vector<ClumpShape> shapes, const ContactProperties& stone_on_stone, double gravity);

  Clumps& clumps() { return clumps_; }
  const Clumps& clumps() const { return clumps_; }
  std::vector<Wall>& walls() { return walls_; }
  const std::vector<Wall>& walls() const { return walls_; }
  double gravity() const { return gravity_; }
  // Another gravity from now on, 0: none [m/s2]. What that adds to the energy of height is booked
  // as inserted. Every stone must be here.
  void set_gravity(double gravity);
  // Pair properties of stones; changing them between steps is allowed.
  ContactProperties& stone_contact() { return stone_on_stone_; }
  const ContactProperties& stone_contact() const { return stone_on_stone_; }

  // A stone. Its id is clumps().next_id(); returns its index.
  int add_clump(int shape, double density, const Vector3& position, const Quaternion& orientation,
                const Vector3& velocity = Vector3::Zero());
  // Removes clumps and books their energy, that of their contacts included. Returns old to new
  // index.
  std::vector<int> remove_clumps(const std::vector<bool>& remove);
  // Adds a wall behind the others and returns its id. What it stores from the start, where it
  // overlaps clumps, is booked as inserted.
  WallId add_wall(const Wall& wall);
  // Removes walls; what their contacts store is booked with negative sign. The others keep theirs.
  void remove_walls(const std::vector<WallId>& ids);
  // Throws std::invalid_argument when there is no such wall (any more).
  Wall& wall(WallId id) { return walls_[wall_index(id)]; }
  const Wall& wall(WallId id) const { return walls_[wall_index(id)]; }

  // From now on the wall keeps a force: every move_walls sets its velocity along the axis of the
  // control (force_control.h, linear contacts). Throws InputError when the control is not usable.
  void control_wall(WallId wall, const ForceControl& control);
  // Another force to keep for a wall that keeps one, 0 or more [N]. Throws std::invalid_argument
  // when it keeps none.
  void set_controlled_force(WallId wall, double force);
  bool keeps_force(WallId wall) const;
  // Whether every wall that keeps a force presses the stones with at least this share of it [-].
  bool controlled_walls_press(double share) const;
  // The wall keeps its force no longer, but the velocity that it has now.
  void release_wall(WallId wall);

  // Walls of triangles (theory/walls.md). What a new one stores from the start, where it overlaps
  // clumps, is booked as inserted. Change their motion between compute_forces and move_walls.
  int add_mesh_wall(const MeshWall& wall);
  std::vector<MeshWall>& mesh_walls() { return mesh_walls_; }
  const std::vector<MeshWall>& mesh_walls() const { return mesh_walls_; }
  const std::vector<MeshContact>& mesh_contacts() const { return mesh_contacts_.contacts(); }

  // Rolling resistance at every contact but those with ribs; meant for single spheres. Linear
  // contact model only.
  void set_rolling(const RollingProperties& rolling) { rolling_properties_ = rolling; }

  // Contact forces and torques (without gravity) at the present poses, in clumps().force and
  // .torque. `dt` is the step over which tangential springs advance [s].
  void compute_forces(double dt);

  // Adds the impulse of the computed forces and of gravity to every clump. `other_force` and
  // `other_torque` (per clump, world, about the centre of mass [N], [N m]) act besides and are
  // added elsewhere: local damping goes by the whole unbalanced force.
  void kick_all(double dt, const VectorField* other_force = nullptr,
                const VectorField* other_torque = nullptr);
  // Moves every clump, except those with (*held)[i] = 1.
  void drift_all(double dt, const ScalarField* held = nullptr);
  // Local damping by this share, see local_damping.h; 0 switches it off [-].
  void set_local_damping(double share) { local_damping_.share = share; }
  double local_damping() const { return local_damping_.share; }
  void move_walls(double dt);

  // One whole step of everything, when there are no ribs.
  void step(double dt);

  // At the present positions and forces (call between compute_forces and kick), for velocities that
  // are half a step of `dt` behind; of all clumps, those of other ranks included. Collective.
  EngineEnergy energy(double dt) const;
  // Of all clumps, those of other ranks included, with the half-step velocities: cheap, for
  // settling criteria [J]; and their mass [kg]. Collective.
  double kinetic_energy() const;
  double mass() const;

  // Bound 2/omega on the stable step from the present contacts: of the clumps, the largest sum over
  // their contacts of k times the largest mobility at the contact, 1/m + the largest eigenvalue of
  // [r]x I^-1 [r]x^T (r: arm, k: the larger of k_n and k_t), doubled because the partner moves too.
  // A norm of a sum is at most the sum of the norms, so this is on the safe side. Dashpots are left
  // to the safety factor. `ribs` adds the contacts with ribs.
  StableStep stable_step(const RibContacts* ribs = nullptr) const;
  // The same before there are contacts, for the shape that would set it if it had `n_contacts`
  // contacts where its surface is most mobile: of the first shapes, one for each density [kg/m3].
  StableStep expected_stable_step(const std::vector<double>& densities, int n_contacts) const;

  // Of two clumps sorted by (i, j, a, b), and at walls sorted by (wall, i, a); those about to touch
  // are among them.
  std::vector<SphereContact> sphere_contacts() const;
  std::vector<WallContact> wall_contacts() const;
  // Counts, and the largest overlap of stones with stones and walls [m], of the last
  // compute_forces; a contact that two ranks evaluate counts on that of the first clump.
  int n_touching_spheres() const;
  double largest_overlap() const;

  // Brute force over all pairs of member spheres: number of overlapping pairs (for tests).
  int count_overlaps_brute_force() const;

  // What the contacts remember, and going on from it: with the field list below, the next
  // compute_forces has the same digits as in the engine that it was taken from.
  ContactMemory memory() const;
  void restore(const ContactMemory& memory);
  // Goes on with these clumps, ids ascending, and what their contacts remember, instead of those
  // that are here. For clumps that change ranks: no energy is booked.
  void replace_clumps(const std::vector<ClumpState>& states, const ContactMemory& memory);
  // From now on other ranks move the other clumps. Forces on walls that are found here are a part
  // of them then, completed in steps in which a wall moves, and otherwise only by
  // complete_wall_forces(). Nothing: everything is here, as at the begin.
  void set_ranks(OverRanks ranks) { ranks_ = std::move(ranks); }
  void complete_wall_forces();
  // Energy in the springs of all contacts with stones and walls at the present poses, for the
  // present properties [J]: what changes when the properties are changed.
  double elastic_energy() const;

  // Levels of the neighbour lists that will have to be built soon, and that the next step shall
  // build: so that ranks do so together (NeighbourLists::Levels).
  NeighbourLists::Levels expiring_lists() const { return lists_.expiring(); }
  void renew_lists(const NeighbourLists::Levels& levels) { lists_.renew(levels); }
  void set_list_settings(const ListSettings& settings) { lists_.set(settings); }
  StepProfile profile() const;
  void reset_profile();

  // Everything that the next step needs. Reading goes into an engine that has its walls of
  // triangles.
  template <class Archive> friend void exchange(Archive& archive, Engine& engine)
  {
    archive("gravity", engine.gravity_, "m/s2");
    archive("stone_contact", engine.stone_on_stone_);
    archive("clumps", engine.clumps_);
    archive("walls", engine.walls_);
    archive("next_wall_id", engine.next_wall_id_);
    archive("controls", engine.controls_);
    std::vector<MeshWallMotion> motions = engine.mesh_wall_motions();
    archive("mesh_walls", motions);
    if (Archive::reading) engine.set_mesh_wall_motions(motions);
    archive("rolling", engine.rolling_properties_);
    archive("lost_before", engine.lost_before_, "J");
    archive("crushed_before", engine.crushed_before_, "J");
    archive("local_damping", engine.local_damping_.share);
    archive("wall_work", engine.wall_work_, "J");
    archive("inserted", engine.inserted_, "J");
    ContactMemory contacts;
    if (!Archive::reading) contacts = engine.memory();
    archive("contacts", contacts);
    if (Archive::reading) engine.restore(contacts);
  }

private:
  struct ControlledWall {
    WallId wall = -1;
    ForceControl control;
    template <class Archive> friend void exchange(Archive& archive, ControlledWall& controlled)
    {
      archive("wall", controlled.wall);
      exchange(archive, controlled.control);
    }
  };
  struct MeshWallMotion {
    MeshWall wall; // without its surface
    template <class Archive> friend void exchange(Archive& archive, MeshWallMotion& motion)
    {
      exchange_motion(archive, motion.wall);
    }
  };

  std::size_t wall_index(WallId id) const;
  std::vector<MeshWallMotion> mesh_wall_motions() const;
  void set_mesh_wall_motions(const std::vector<MeshWallMotion>& motions);
  double elastic_energy(const SphereContact& contact) const;
  double elastic_energy(const WallContact& contact) const;
  double body_energy(int clump) const;
  std::vector<double> stored_energies() const;
  void resist_rolling(double dt);
  bool a_wall_moves() const;

  Clumps clumps_;
  std::vector<Wall> walls_;
  WallId next_wall_id_ = 0;
  std::vector<ControlledWall> controls_;
  std::vector<MeshWall> mesh_walls_;
  NeighbourLists lists_;
  BodyRecords records_;
  BodySums sums_;
  MeshContacts mesh_contacts_;
  RollingProperties rolling_properties_;
  RollingResistance rolling_;
  ContactProperties stone_on_stone_;
  double gravity_;
  LocalDamping local_damping_;
  Vector3 lost_before_ = Vector3::Zero(); // by clumps that were removed, as Clumps::lost [J]
  double crushed_before_ = 0;             // likewise, Clumps::lost_to_crushing [J]
  double wall_work_ = 0, inserted_ = 0;   // [J]
  OverRanks ranks_;
  bool wall_forces_are_whole_ = true;
  ScalarField nothing_held_;
  StepProfile profile_;
  double broad_phase_before_ = 0;
};
} // namespace interlock::dem
