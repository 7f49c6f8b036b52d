// Contacts of ribs with the walls of the box and the edges of its slot: springs, dashpots and
// friction of vertices and elements of the lattice (docs/theory/geogrid.md). World frame, SI units.
#pragma once

#include "coupling/loop/node_rate.h"
#include "coupling/loop/rib_wall_points.h"
#include "dem/contacts/contact_memory.h"
#include "fem/explicit/explicit_dynamics.h"

#include <vector>

namespace interlock::coupling
{
// A contact that may touch, and what it remembers. Sorted by (vertex, side).
struct RibTouch {
  int vertex = 0; // slot of the lattice; of an element the one at which it begins
  BoxSide side = BoxSide::floor;
  dem::ContactHistory history;               // of the rib against the wall
  dem::Vector3 force = dem::Vector3::Zero(); // on the rib, at the last evaluation [N]
};

template <class Archive> void exchange(Archive& archive, RibTouch& touch)
{
  archive("vertex", touch.vertex);
  archive("side", touch.side);
  archive("history", touch.history);
  archive("force", touch.force, "N");
}

// Everything that a restart needs; losses since the start have one entry a slot, or none where ribs
// do not touch walls.
struct RibWallState {
  std::vector<RibTouch> touches;
  std::vector<double> friction, damping; // [J]
};

template <class Archive> void exchange(Archive& archive, RibWallState& state)
{
  archive("touches", state.touches);
  archive("friction", state.friction, "J");
  archive("damping", state.damping, "J");
}

class RibWalls
{
public:
  // Of a lattice that is unloaded in its place, with its motion in `ribs`: their ends are the slots
  // of `dynamics`, and rib r is its element r.
  RibWalls(const RibBox& box, const dem::RibSet& ribs, const fem::ExplicitDynamics& dynamics);

  // Chooses the contacts that may touch within a step `dt` [s]: a function of the motion of each
  // vertex or element alone. Of a part of the lattice, those of the ends that are present.
  void update(const dem::RibSet& ribs, double dt);

  // Evaluates them over `h` [s], for velocities half of it back, and adds their loads to the
  // lattice.
  void load(const dem::RibSet& ribs, double h, fem::ExplicitDynamics& dynamics);

  // What those that touch add to the bounds of the nodes that they load.
  void add_rates(const dem::RibSet& ribs, std::vector<NodeRate>& rates) const;

  // Stored now, and lost since the start. Of the whole lattice where its state is here.
  dem::ContactEnergy energy() const;
  // On the geogrid, at the last evaluation [N].
  dem::Vector3 force() const;
  // Of the ribs as they are now; not negative [m].
  double largest_overlap(const dem::RibSet& ribs) const;

  const std::vector<RibTouch>& touches() const { return touches_; }
  void set_touches(std::vector<RibTouch> touches) { touches_ = std::move(touches); }
  // Losses, one entry a slot: what parts of the lattice give each other besides touches.
  std::vector<double*> rows() { return {friction_.data(), damping_.data()}; }

  RibWallState state() const;
  // One without losses starts from none.
  void set_state(const RibWallState& state);

private:
  void evaluate(RibTouch& touch, const WallGap& gap, const dem::RibSet& ribs, double h);
  double mass_at(int vertex, double xi) const; // [kg]

  RibBox box_;
  RibWallPoints points_;
  std::vector<int> node_;    // of each slot
  std::vector<double> mass_; // of each slot [kg]
  std::vector<RibTouch> touches_;
  std::vector<double> friction_, damping_; // by slot, padded to whole blocks [J]
};
} // namespace interlock::coupling
