// A large lattice, of which each rank moves a part (docs/theory/parallel.md).
#pragma once

#include "coupling/loop/rib_transfer.h"
#include "dem/bodies/clumps.h"
#include "dem/parallel/domain.h"
#include "dem/parallel/halo.h"

#include <vector>

namespace interlock::coupling
{
// Whether ranks share this lattice out. Below some 2000 elements it costs less to move all of it
// on every rank than to send each other its motion in every sub-step.
bool has_parts(const fem::Lattice& lattice);

// What the parts of a lattice cost, and where, for the dealing of stones: nothing where ranks have
// the whole.
std::vector<dem::PlaceCost> costs_of_parts(const RibTransfer& geogrid);

// How near ribs and a sphere may be now that are contacts or near contacts (RibContacts) before
// stones are dealt anew, if both may move by `room`: gap [m].
double reach_until_dealt(double room);

// The geogrid's slots (fem::ExplicitDynamics) go in blocks to the ranks that own their places. A
// rank has, besides, the motion of slots at the border of its own, and of all ribs that its stones
// could touch; it comes from the ranks that move them, after each sub-step. The arrays stay those
// of the whole lattice: memory is not shared out.
class LatticeParts
{
public:
  // `clumps` are those that have just been dealt. All ranks have the whole geogrid, which must
  // outlive this object and keeps its part until RibTransfer::hold_all. Collective among all ranks.
  LatticeParts(const dem::Domain& domain, const dem::Clumps& clumps, RibTransfer& geogrid);

  // Other ranks that have motion for this one or need that of its slots, whose slots its contacts
  // may load, or whose contacts may load its slots. Ascending; each is a neighbour of the other.
  const std::vector<int>& neighbours() const { return neighbours_; }

  // Copies the motion of slots from the ranks that move them. Collective among neighbours.
  void refresh() { halo_.refresh(motion_rows_); }
  // Gives everything of all parts to every rank. Collective among all.
  void gather() const;

private:
  std::vector<int> near_ribs(const dem::Domain& domain, const dem::Clumps& clumps) const;
  void connect(const std::vector<int>& needed, const std::vector<bool>& loads);
  void gather_touches() const;

  const dem::Ranks& ranks_;
  RibTransfer& geogrid_;
  std::vector<std::vector<int>> blocks_; // by rank, ascending
  std::vector<int> owner_;               // of slots
  std::vector<double*> motion_rows_;
  dem::Halo halo_;
  std::vector<int> neighbours_;
};
} // namespace interlock::coupling
