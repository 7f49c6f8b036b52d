// The ranks that move a geogrid together, and what they tell each other.
//
// Each of them has the whole lattice and steps it itself. Contacts of a stone with ribs are
// evaluated by the rank that moves the stone; what all of them do to the lattice is put together,
// in each sub-step, in the order that one rank would find, so that all lattices stay the same to
// the last digit (docs/theory/parallel.md).
#pragma once

#include "coupling/loop/rib_transfer.h"
#include "dem/bodies/clumps.h"
#include "dem/parallel/rank_group.h"
#include "dem/ribs/rib_contacts.h"

#include <cstdint>
#include <vector>

namespace interlock::coupling
{
class GeogridRanks
{
public:
  // Ranks with stones that could come to the geogrid while both move by less than `room` [m], and
  // the first one, which keeps records of it. Collective among all ranks.
  GeogridRanks(const dem::Ranks& ranks, const dem::Clumps& clumps, const dem::RibSet& ribs,
               double room);

  bool moves_here() const { return group_.is_member(); }
  bool moves_everywhere() const { return group_.is_everybody(); }

  // The loads of all contacts that load ribs, from those that this rank has evaluated last, in the
  // order of (id of the clump, sphere, line). Collective among the ranks of the geogrid, as the
  // next one.
  const std::vector<dem::RodLoads>& all_loads(const std::vector<dem::RodLoads>& mine,
                                              const dem::RibContacts& contacts,
                                              const dem::Clumps& clumps);
  // Those of all.
  std::vector<NodeRate> all_rates(const std::vector<NodeRate>& mine) const;

private:
  // As it travels.
  struct KeyedLoad {
    std::int64_t clump;
    std::int32_t sphere, line, rib, unused;
    double numbers[12]; // forces and moments at both ends
  };

  dem::RankGroup group_;
  std::vector<KeyedLoad> mine_;
  std::vector<dem::RodLoads> loads_;
};
} // namespace interlock::coupling
