// Explicit dynamics of a lattice: lumped mass, leapfrog, unit quaternions. The integrator that the
// coupled loop steps together with the stones.
#pragma once

#include "fem/beam/section_forces.h"
#include "fem/explicit/beam_lanes.h"
#include "fem/explicit/bent_beams.h"
#include "fem/explicit/stable_step.h"
#include "fem/lattice/beam_constants.h"
#include "fem/lattice/lattice.h"
#include "fem/lattice/lumped_inertia.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace interlock::fem
{
struct DynamicsOptions {
  Eigen::Vector3d gravity{0, 0, 0}; // world [m/s2]
  double mass_damping = 0;          // alpha: force -alpha m v on every free node [1/s]
  bool rbf = true;                  // residual bending flexibility in the shear stiffness
  bool spherical_inertia = true;    // see lump_inertia
};

// Energies [J] half a step back from the positions, where the leapfrog velocities live. In a linear
// system kinetic + elastic + gravitational + damping_loss + plastic_loss - clamp_work - load_work
// is constant to rounding at any stable step; in general its error falls with the square of the
// step.
struct LatticeEnergies {
  double kinetic = 0;       // translation and rotation
  double elastic = 0;       // strain energy of all elements
  double gravitational = 0; // zero at z = 0 for gravity along -z
  double clamp_work = 0;    // done on the lattice by the clamp since the start
  double load_work = 0;     // done on the lattice by the applied loads since the start
  double damping_loss = 0;  // taken by mass damping since the start
  double plastic_loss = 0;  // plastic work of all elements since they were new
  double ledger() const
  {
    return kinetic + elastic + gravitational + damping_loss + plastic_loss - clamp_work - load_work;
  }
};

// What the stable step of a lattice goes by: maxima over its elements, so those of its parts make
// that of the whole.
struct LatticeExtremes {
  double force = 0;           // at the last step [N]
  double plastic_stretch = 0; // [-]
  double bend = 0;            // BentBeams::largest [1/s2]
};

// Everything that a restart needs; one entry a node, world frame. `angular_momentum` is empty with
// spherical inertia. `plastic_stretch` has one entry an element and is empty where no rib softens
// or yields. Work is kept slot by slot, since the start [J].
struct LatticeState {
  std::vector<Eigen::Vector3d> position;                   // [m]
  std::vector<Eigen::Quaterniond> orientation;             // unit, rotation from the unloaded state
  std::vector<Eigen::Vector3d> velocity;                   // half a step back [m/s]
  std::vector<Eigen::Vector3d> spin;                       // half a step back [rad/s]
  std::vector<Eigen::Vector3d> angular_momentum;           // half a step back [kg m2/s]
  std::vector<double> plastic_stretch;                     // up to the last step's start [-]
  std::vector<double> clamp_work, load_work, damping_loss; // one entry a slot [J]
  double previous_step = 0;                                // [s]
  double largest_force = 0;                                // of any element at the last step [N]
};

template <class Archive> void exchange(Archive& archive, LatticeState& state)
{
  archive("position", state.position, "m");
  archive("orientation", state.orientation);
  archive("velocity", state.velocity, "m/s");
  archive("spin", state.spin, "rad/s");
  archive("angular_momentum", state.angular_momentum, "kg m2/s");
  archive("plastic_stretch", state.plastic_stretch);
  archive("clamp_work", state.clamp_work, "J");
  archive("load_work", state.load_work, "J");
  archive("damping_loss", state.damping_loss, "J");
  archive("previous_step", state.previous_step, "s");
  archive("largest_force", state.largest_force, "N");
}

// Steps the lattice. Each step takes the loads and the clamp velocity that were set before it. All
// vectors are in the world frame. Accessors give positions at the present time t and velocities at
// t - h/2. Sums run in an order fixed by the lattice, so equal input gives equal digits, also where
// several processes have a part of it each.
//
// Storage: every rib vertex has a slot, in the order of the lines; the slots of a junction always
// hold the same values. Neighbours along a rib are then neighbours in memory and vector lanes need
// no gathers.
class ExplicitDynamics
{
public:
  // Starts in the unloaded state at rest. Keeps its own copy of the lattice. Throws
  // std::invalid_argument when junctions have rotational stiffness: slots of a junction move as
  // one.
  ExplicitDynamics(const Lattice& lattice, const DynamicsOptions& options);

  const Lattice& lattice() const { return lattice_; }
  const DynamicsOptions& options() const { return options_; }

  // --- Motion of nodes and elements -------------------------------------------------------------
  Eigen::Vector3d position(int node) const { return vector_at(position_, node_slot_[node]); } // [m]
  Eigen::Vector3d velocity(int node) const
  {
    return vector_at(velocity_, node_slot_[node]);
  }                                                                                   // [m/s]
  Eigen::Vector3d spin(int node) const { return vector_at(spin_, node_slot_[node]); } // [rad/s]
  // Rotation from the unloaded state.
  Eigen::Quaterniond orientation(int node) const { return quaternion_at(node_slot_[node]); }

  // Position of one end (0 or 1) of an element, and velocity and spin at its length share xi in [0,
  // 1], linear between the ends: the interpolation that `add_load` is dual to.
  Eigen::Vector3d end_position(int e, int end) const
  {
    return vector_at(position_, element_slot_[e] + end);
  }
  // Rotation of one end of an element from the unloaded state.
  Eigen::Quaterniond end_orientation(int e, int end) const
  {
    return quaternion_at(element_slot_[e] + end);
  }
  Eigen::Vector3d velocity_at(int e, double xi) const { return interpolate(velocity_, e, xi); }
  Eigen::Vector3d spin_at(int e, double xi) const { return interpolate(spin_, e, xi); }

  // The same for all at once, one row a component (quaternions: w x y z), one entry a slot; an
  // element goes from its first slot to the next one.
  int n_slots() const { return n_slots_; }
  int first_slot(int e) const { return element_slot_[e]; }
  std::vector<std::vector<int>> slots_of_nodes() const; // ascending
  const Lanes3& slot_positions() const { return position_; }
  const Lanes3& slot_velocities() const { return velocity_; }
  const Lanes3& slot_spins() const { return spin_; }
  const Lanes4& slot_orientations() const { return orientation_; }

  // --- Inertia, for the stable step of contacts --------------------------------------------------
  double mass(int node) const { return nodes_[node].mass; } // [kg]
  // Smallest principal rotary inertia; with spherical inertia the only one [kg m2].
  double inertia(int node) const { return smallest_inertia_[node]; }

  // --- Loads ------------------------------------------------------------------------------------
  void clear_loads();

  // Adds a force [N] that acts on the centre line of element e at length share xi in [0, 1], and a
  // moment [N m] about that point. Each node takes its linear share of both, so that the nodes
  // receive the power force . velocity_at(e, xi) + moment . spin_at(e, xi) to rounding.
  void add_load(int e, double xi, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
  {
    const int s = element_slot_[e];
    for (int c = 0; c < 3; ++c) {
      load_force_[c][s] += (1 - xi) * force[c];
      load_force_[c][s + 1] += xi * force[c];
      load_torque_[c][s] += (1 - xi) * moment[c];
      load_torque_[c][s + 1] += xi * moment[c];
    }
    loaded_slots_.insert(loaded_slots_.end(), {s, s + 1});
  }

  // The same at one end (0 or 1).
  void add_end_load(int e, int end, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
  {
    add_slot_load(element_slot_[e] + end, force, moment);
  }

  // The same at a slot.
  void add_slot_load(int slot, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
  {
    for (int c = 0; c < 3; ++c) {
      load_force_[c][slot] += force[c];
      load_torque_[c][slot] += moment[c];
    }
    loaded_slots_.push_back(slot);
  }

  // Adds a force [N] and a moment [N m] at a node.
  void add_nodal_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);

  // --- Clamp ------------------------------------------------------------------------------------
  // From now on these nodes move with the clamp velocity and do not turn; all others are free.
  void clamp(const std::vector<int>& nodes);
  // Prescribes every node: the rigid geogrid.
  void clamp_all();
  // Velocity of all clamped nodes from the next step on [m/s].
  void set_clamp_velocity(const Eigen::Vector3d& velocity) { clamp_velocity_ = velocity; }
  // Force that the clamp exerted on the lattice in the last step, inertia of the clamped nodes
  // included: sum of mass * acceleration minus all other forces on them [N].
  Eigen::Vector3d clamp_reaction() const;
  // That force node by node: one entry a slot, zero where the slot is free or another slot of the
  // same node has it [N].
  const Lanes3& slot_clamp_forces() const { return clamp_force_; }

  // --- Time -------------------------------------------------------------------------------------
  // Advances by h [s]. The first step after the start kicks by h/2 only, which puts the velocities
  // half a step back.
  void step(double h);

  // Largest stable step without contacts [s] in the present shape, see BeamFrequency, BentBeams.
  double stable_step() const { return stable_step(extremes(true)); }
  double stable_step(const LatticeExtremes& of) const
  {
    return frequency_.stable_step(of.force, of.plastic_stretch, of.bend);
  }
  // Of the elements that are moved here. The bends, zero if they are not asked for, cost as much as
  // a step; the rest costs nothing.
  LatticeExtremes extremes(bool with_bends) const;

  // --- A part of the lattice, where several processes step it together ---------------------------
  // Slots are moved in blocks of so many, one behind the other; block b begins with slot b times
  // that.
  static int slots_of_block();
  int n_blocks() const { return n_padded_ / slots_of_block(); }
  // From now on step() moves the slots of these blocks only, ascending; at first it moves all. The
  // caller keeps the motion of border_slots() up to date, and everything that is asked for by node
  // or element is right where the caller has brought it here. Digits are those of the whole.
  void move_blocks(const std::vector<int>& blocks);
  void move_all_blocks();
  // Slots that are not moved here and lie on elements which load those that are; ascending.
  const std::vector<int>& border_slots() const { return border_slots_; }
  // What extremes() says from now on, until the next step: where the rest of the lattice has come
  // here from other processes.
  void set_extremes(const LatticeExtremes& of)
  {
    largest_force_ = of.force;
    largest_plastic_stretch_ = of.plastic_stretch;
  }
  // Arrays with an entry for each slot: its motion (position [m], velocity [m/s], spin [rad/s],
  // orientation w x y z), 13 of them; and everything that step() changes and needs again.
  std::vector<double*> motion_rows();
  std::vector<double*> all_rows();

  LatticeEnergies energies() const;
  // Internal forces of an element for output, in its mid frame.
  SectionForces section_forces(int e) const;
  // Stretch that stays when an element is unloaded [-]; history up to the start of the last step.
  double plastic_stretch(int e) const { return beams_.plastic_stretch[element_slot_[e]]; }

  LatticeState state() const;
  // Throws std::invalid_argument when an array has not one entry for every node or element.
  void set_state(const LatticeState& state);

private:
  static Eigen::Vector3d vector_at(const Lanes3& lanes, int slot)
  {
    return {lanes[0][slot], lanes[1][slot], lanes[2][slot]};
  }
  Eigen::Quaterniond quaternion_at(int slot) const
  {
    return {orientation_[0][slot], orientation_[1][slot], orientation_[2][slot],
            orientation_[3][slot]};
  }
  Eigen::Vector3d interpolate(const Lanes3& lanes, int e, double xi) const
  {
    const int s = element_slot_[e];
    return (1 - xi) * vector_at(lanes, s) + xi * vector_at(lanes, s + 1);
  }

  void number_slots();
  void size_lanes();
  void fill_beam_constants();
  void fill_node_constants();

  BeamConstants<double> constants(int e) const
  {
    return beam_constants(lattice_, e, options_.rbf, plastic_stretch(e));
  }
  template <Tension tension> void compute_element_loads();
  void sum_at_slots(bool with_elements);
  void sum_at_junctions();
  template <bool spherical> void update_nodes(double kick, double h);
  template <Tension tension> double elastic_energy(double time_back) const;
  double plastic_loss(double time_back) const;

  int block_of(int slot) const { return slot / slots_of_block(); }

  Lattice lattice_;
  DynamicsOptions options_;
  std::vector<NodeInertia> nodes_;
  std::vector<double> smallest_inertia_;
  BeamFrequency frequency_;
  bool softens_ = false;               // some rib softens or yields
  double largest_force_ = 0;           // of any element at the last step [N]
  double largest_plastic_stretch_ = 0; // of any element [-]

  // Slots: of the first end of each element, the first one of each node, all of each junction.
  int n_slots_ = 0, n_padded_ = 0;
  std::vector<int> element_slot_, node_slot_, slot_node_;
  std::vector<std::vector<int>> junction_slots_;

  // What is stepped here: first slots of the blocks that are moved, and of others with elements
  // that load them; junctions with slots among those.
  std::vector<int> moved_, border_, border_slots_, junctions_;

  // State, one entry a slot.
  Lanes3 position_, velocity_, spin_, angular_momentum_;
  Lanes4 orientation_;

  BeamLanes beams_;
  BentBeams bent_;

  // Mass, inertia (the spherical value, or the six entries xx yy zz xy xz yz of the tensor and of
  // its inverse), 1 for clamped slots, 1 for the slot that counts for its node in sums.
  Lane mass_, inverse_mass_, clamped_, counts_;
  std::array<Lane, 6> inertia_, inverse_inertia_;

  // Loads: applied, of elements on their first and second ends, total.
  Lanes3 load_force_, load_torque_;
  std::vector<int> loaded_slots_; // with repetitions
  Lanes3 beam_force_, beam_torque1_, beam_torque2_;
  Lanes3 force_, torque_;

  bool all_clamped_ = false;
  Eigen::Vector3d clamp_velocity_{0, 0, 0};
  Lanes3 clamp_force_;                         // in the last step
  Lane clamp_work_, load_work_, damping_loss_; // since the start
  double previous_step_ = 0;
};
} // namespace interlock::fem
