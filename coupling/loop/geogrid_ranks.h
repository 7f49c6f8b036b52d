// The ranks that move a geogrid together, and what they tell each other.
//
// Contacts of a stone with ribs are evaluated by the rank that moves the stone; what all of them do
// to the lattice is put together, in each sub-step, in the order that one rank would find. Each of
// these ranks has the whole lattice and steps it itself, and so all lattices stay the same to the
// last digit; or, where the lattice is large, a part of it, which has the digits of the whole
// (LatticeParts, docs/theory/parallel.md).
#pragma once

#include "coupling/loop/lattice_parts.h"
#include "coupling/loop/rib_transfer.h"
#include "dem/bodies/clumps.h"
#include "dem/parallel/domain.h"
#include "dem/parallel/rank_group.h"
#include "dem/ribs/rib_contacts.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace interlock::coupling
{
class GeogridRanks
{
public:
  // Ranks with stones that could come to the geogrid until they are dealt anew, and the first one,
  // which keeps records of it; all, if the lattice is large. `clumps` are those that have just been
  // dealt. All ranks have the whole geogrid, which must outlive this object. Collective among all.
  GeogridRanks(const dem::Domain& domain, const dem::Clumps& clumps, RibTransfer& geogrid);

  bool moves_here() const { return group_.is_member(); }
  bool moves_everywhere() const { return parts_ || group_.is_everybody(); }

  // The loads of all contacts that load ribs which are moved here, from those that this rank has
  // evaluated last, in the order of (id of the clump, sphere, line). Collective among the ranks of
  // the geogrid, as the next one.
  const std::vector<dem::RodLoads>& all_loads(const std::vector<dem::RodLoads>& mine,
                                              const dem::RibContacts& contacts,
                                              const dem::Clumps& clumps);
  // Those of all, likewise.
  std::vector<NodeRate> all_rates(const std::vector<NodeRate>& mine) const;

  // Where every rank moves a part of the lattice; nothing happens, and what is here is all, where
  // each has the whole. Collective among the ranks of the geogrid.
  SubstepNeeds largest_of_parts(const SubstepNeeds& mine) const;
  dem::Vector3 sum_of_parts(const dem::Vector3& mine) const; // of terms on a grid
  // The motion that this rank needs of other parts; and everything, to all ranks.
  void refresh();
  void gather() const;

private:
  // As it travels.
  struct KeyedLoad {
    std::int64_t clump;
    std::int32_t sphere, line, rib, unused;
    double numbers[12]; // forces and moments at both ends
  };

  const dem::Ranks& ranks_;
  std::optional<LatticeParts> parts_;
  dem::RankGroup group_;
  std::vector<KeyedLoad> mine_;
  std::vector<dem::RodLoads> loads_;
};
} // namespace interlock::coupling
