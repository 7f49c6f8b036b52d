// The transfer between the two sides of the geogrid: motion goes from the beam lattice of fem to
// the ribs of dem, contact wrenches go from the ribs to the nodes of the lattice.
#pragma once

#include "coupling/loop/node_rate.h"
#include "coupling/loop/rib_walls.h"
#include "dem/ribs/rib_contacts.h"
#include "fem/explicit/explicit_dynamics.h"

#include <optional>
#include <vector>

namespace interlock::coupling
{
// What the number of sub-steps goes by: maxima, so those of parts of a lattice make that of the
// whole.
struct SubstepNeeds {
  double contacts = 0; // largest sum of the rates at one node [1/s2]
  fem::LatticeExtremes beams;
};

// Owns the lattice, its motion and its clamp. Rib r of dem is element r of fem: that is the whole
// map between them.
class RibTransfer
{
public:
  // `clamped` nodes are moved by the clamp, all of them for a rigid geogrid; `edge_rounding` is the
  // radius of the ribs' edges [m]. The outer sizes of the ribs are those of the lattice's lines.
  // With a box, in whose frame the lattice is, ribs touch its walls, too.
  RibTransfer(const fem::Lattice& unloaded, const fem::DynamicsOptions& options,
              const std::vector<int>& clamped, bool rigid, double edge_rounding,
              const std::optional<RibBox>& box = {});

  const fem::Lattice& lattice() const { return dynamics_.lattice(); }
  fem::ExplicitDynamics& dynamics() { return dynamics_; }
  const fem::ExplicitDynamics& dynamics() const { return dynamics_; }
  const dem::RibSet& ribs() const { return ribs_; }
  bool rigid() const { return rigid_; }
  // Contacts with the box; null where ribs do not touch it.
  const RibWalls* walls() const { return walls_ ? &*walls_ : nullptr; }
  RibWalls* walls() { return walls_ ? &*walls_ : nullptr; }

  // Copies the lattice's motion to the ribs.
  void refresh_ribs();

  // Chooses the contacts with walls for a step `dt` [s].
  void update_walls(double dt);

  // Puts the loads of stones on the lattice, in their order, instead of those before.
  void apply(const std::vector<dem::RodLoads>& loads);
  // Adds those of walls, over `h` [s].
  void apply_walls(double h);

  // What each contact adds to the bounds of the nodes that it loads: k N (1/m + arm^2/J).
  std::vector<NodeRate> contact_rates(const dem::RibContacts& contacts) const;
  // The same of contacts with walls, as far as they are known here: of every node that is moved
  // here, all.
  void add_wall_rates(std::vector<NodeRate>& rates) const;
  // Of these contacts and of the elements that are moved here. How far ribs are bent is looked at
  // if asked for, which takes as long as a sub-step of the beams.
  SubstepNeeds substep_needs(const std::vector<NodeRate>& rates, bool with_bends = true);
  // Number of equal sub-steps in a step `dt` [s] that keeps beams and contacts stable: 1/h^2 =
  // 1/h_beam^2 + the largest sum, over the contacts at one node, of its rates / 4, with the
  // dashpot's factor sqrt(1 + z^2) - z and a margin of 0.75 (a dashpot at a lever arm shortens the
  // step more than that factor says). At least 2; 1 for a rigid geogrid.
  int required_substeps(double dt, const SubstepNeeds& needs, double damping_ratio) const;

  // Mean force of the clamp on the lattice over the last step, of the nodes that are moved here:
  // its terms are on a grid (dem/exact_sums.h) [N].
  dem::Vector3 clamp_force() const;

  // From now on these blocks of slots are moved here, and the motion of `known` slots comes from
  // elsewhere (fem::ExplicitDynamics::move_blocks): both ascending. Ribs with other ends are not
  // looked at.
  void hold_part(const std::vector<int>& blocks, const std::vector<int>& known);
  void hold_all();

  double mass() const { return lattice().mass(); } // [kg]

  // The motion; the lattice itself follows from the parameters.
  template <class Archive> friend void exchange(Archive& archive, RibTransfer& geogrid)
  {
    fem::LatticeState state;
    RibWallState walls;
    if (!Archive::reading) {
      state = geogrid.dynamics_.state();
      if (geogrid.walls_) walls = geogrid.walls_->state();
    }
    exchange(archive, state);
    archive("walls", walls);
    if (!Archive::reading) return;
    geogrid.dynamics_.set_state(state);
    if (geogrid.walls_) geogrid.walls_->set_state(walls);
    geogrid.refresh_ribs();
  }

private:
  bool rigid_;
  fem::ExplicitDynamics dynamics_;
  dem::RibSet ribs_; // their ends are the slots of the lattice
  std::optional<RibWalls> walls_;
  std::vector<int> clamped_;       // slots, of those that are moved here
  std::vector<double> node_rates_; // zero between uses
  std::vector<bool> is_clamped_;   // by node
};
} // namespace interlock::coupling
