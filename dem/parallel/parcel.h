// What travels when clumps change ranks: clumps, and what their contacts remember.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/contacts/contact_memory.h"
#include "dem/parallel/ranks.h"

#include <algorithm>
#include <vector>

namespace interlock::dem
{
// World frame, SI units, as in a checkpoint.
struct Parcel {
  std::vector<ClumpState> clumps;
  ContactMemory contacts;

  // Lets go of the contacts for which `wanted` is false: of their clump and of the second one, or
  // -1 at walls.
  template <class Function> void keep(const Function& wanted)
  {
    const auto filter = [](auto& list, const auto& is_wanted) {
      list.erase(
          std::remove_if(list.begin(), list.end(), [&](const auto& c) { return !is_wanted(c); }),
          list.end());
    };
    filter(contacts.pairs, [&](const PairMemory& c) { return wanted(c.first, c.second); });
    filter(contacts.walls, [&](const WallMemory& c) { return wanted(c.clump, -1); });
    filter(contacts.meshes, [&](const MeshMemory& c) { return wanted(c.clump, -1); });
    filter(contacts.rolling,
           [&](const RollingMemory& c) { return wanted(c.first, c.kind == 0 ? c.second : -1); });
  }

  // As a message, and one out of several: clumps ascending in id, contacts in the order that
  // ContactMemory promises.
  Bytes packed() const;
  static Parcel merged(const std::vector<Bytes>& messages);
};
} // namespace interlock::dem
